#pragma once

#include "core/io/drawing/drawing.h"

namespace kriva {

/// TeX has no longer lengths: 16383 of its points, in millimetres, and a little room.
inline constexpr double kMostTexSide = 5700;

/// A figure for LaTeX, in TikZ: lengths in millimetres, y up, the page as its bounding box. Curves of degree 1, 2 and 3
/// are what TikZ draws exactly, higher ones cubics within kCubicTolerance. Each way of drawing is a style, and each
/// point with a name a coordinate of that name: change them once. Labels are set in the document's own font. The same
/// drawing gives the same bytes.
[[nodiscard]] std::string writeTikz(const Drawing& drawing, const TextSource& texts, TikzKind kind);

} // namespace kriva
