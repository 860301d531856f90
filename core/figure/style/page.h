#pragma once

#include "core/geometry/box.h"

#include <optional>

namespace kriva {

/// The sheet of paper that a figure is drawn on, in millimetres: x to the right, y down, from the top left corner.
struct Page {
    double width = 0;
    double height = 0;
    double mmPerUnit = 1;
    double margin = 0;
    Box box; ///< of the figure, in document coordinates: what lies inside the margin
};

/// Room around the figure for marks and labels, in millimetres.
inline constexpr double kPageMargin = 6;
/// The longer side of a page whose scale is not set, in millimetres.
inline constexpr double kPageSide = 120;

/// The page of what lies in the box. Without a scale, the page's longer side is kPageSide; where the box has no size
/// (no point, or all in one place), a unit is a millimetre and the page nothing but margin.
[[nodiscard]] Page pageOf(const Box& box, std::optional<double> mmPerUnit = {}, double margin = kPageMargin);

/// The page of that width, in millimetres and more than both margins: its scale follows. Where the box has no width, a
/// page with the scale of pageOf and the box in its middle.
[[nodiscard]] Page pageOfWidth(const Box& box, double width, double margin = kPageMargin);

/// A place of the document on the page, to 4 ulp of the page's longer side.
[[nodiscard]] Point onPage(const Page& page, Point p);

} // namespace kriva
