#pragma once

#include <QImage>

#include <png.h>

namespace kriva::ui {

/// Writes a picture a part at a time, since a whole one may take a GiB. Qt's own writer wants it at once, and chooses a
/// filter for each row, which takes longer than all else and makes drawings no smaller.
class PngWriter {
  public:
    enum class Ground { paper, transparent };

    /// `size` in pixels, each side at least 1.
    PngWriter(QSize size, Ground ground, int dotsPerMetre);
    ~PngWriter();
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    /// The next rows: so many of a picture of the same width, from `top` on.
    void add(const QImage& picture, int top, int rows);
    /// The file, after the last row.
    [[nodiscard]] QByteArray finish();

  private:
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    Ground ground_;
    QByteArray bytes_;
};

} // namespace kriva::ui
