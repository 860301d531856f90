#pragma once

#include "core/figure/role_style.h"
#include "ui/canvas/base/viewport.h"

#include <QPixmap>

#include <limits>
#include <span>
#include <vector>

class QPainter;

namespace kriva::ui {

/// One small picture at many places. Both count in device pixels, so that painting is plain copying.
struct Stamps {
    QPixmap picture;
    std::vector<QPoint> places; ///< of the picture's top left corner
};

/// A mark in the middle of a picture that just holds it.
[[nodiscard]] QPixmap markPicture(const RoleStyle& style, double devicePixelRatio);

/// The pictures of marks, each painted once: a sheet of many curves asks for the same few again and again.
class MarkPictures {
  public:
    [[nodiscard]] QPixmap picture(const RoleStyle& style, double devicePixelRatio);

  private:
    struct Entry {
        RoleStyle style;
        double devicePixelRatio = 1;
        QPixmap picture;
    };
    std::vector<Entry> entries_;
};

/// Where marks are seen.
struct StampView {
    Viewport viewport;
    double devicePixelRatio = 1;
    int spacing = 1; ///< device pixels: of marks in the same square of this side one stands for all
    double most = std::numeric_limits<double>::infinity(); ///< once more places than this are found, no more are sought
};

/// The picture centred on those of the points that are seen.
[[nodiscard]] Stamps stampsAt(std::span<const Point> points, QPixmap picture, const StampView& view);

void paint(QPainter& painter, const Stamps& stamps, double devicePixelRatio);

} // namespace kriva::ui
