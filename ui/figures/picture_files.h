#pragma once

#include "core/io/drawing/drawing.h"

#include <QByteArray>
#include <QSize>

/// Figures in the formats that Qt writes, made in memory.
namespace kriva::ui {

inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr int kMostPixels = 16'384;     ///< of a side of a PNG
inline constexpr int kPixelsAtOnce = 64 << 20; ///< of a PNG are painted: nearly all of them whole

/// Of a page at so many dots per inch, each side at least 1.
[[nodiscard]] QSize pixelSize(const Page& page, int dpi);

/// A picture of pixelSize, no side above kMostPixels; transparent where the drawing has no paper. The same drawing
/// gives the same bytes, however many pixels are painted at once.
[[nodiscard]] QByteArray writePng(const Drawing& drawing, const TextSource& texts, int dpi = kUsualDpi,
                                  int pixelsAtOnce = kPixelsAtOnce);

/// One page as large as the drawing to 0.2 mm, since Qt rounds to whole points; fonts embedded. The same drawing gives
/// the same bytes, but for the date, which SOURCE_DATE_EPOCH sets.
[[nodiscard]] QByteArray writePdf(const Drawing& drawing, const TextSource& texts);

} // namespace kriva::ui
