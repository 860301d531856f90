#pragma once

#include "core/figure/figure.h"
#include "core/figure/style/theme.h"

#include <vector>

/// How each role looks: the one place that canvas, plots and exports take it from. Lengths are in points (1/72 inch)
/// and never scaled with the figure.
namespace kriva {

/// Roles differ by colour, and without colour by line (width, dashes) or marker (shape, size, whether it is hollow).
struct RoleStyle {
    Color color;                ///< of the line, the outline of marks and the text
    double width = 0;           ///< of the line; 0 where the role has none
    std::vector<double> dashes; ///< dash, gap, dash, gap ... ; empty for a solid line
    Marker marker = Marker::none;
    double markerSize = 0;  ///< diameter of a circle, side of a square, diagonal of a diamond, without the outline
    double markerWidth = 0; ///< of the outline
    Color markerFill;       ///< the paper's colour for hollow marks; a ring is not filled
};

/// The style of a role; `series` counts levels or runs from 0 and repeats in cycles.
[[nodiscard]] RoleStyle styleOf(Role role, int series, Theme theme);

/// The style of a stroke: that of its role, with the colour, the width and the dashes that its curve sets.
[[nodiscard]] RoleStyle styleOf(const Stroke& stroke, Theme theme);

/// The style of marks: that of their role, with the shape that their curve sets.
[[nodiscard]] RoleStyle styleOf(const Marks& marks, Theme theme);

/// The colour of a label of that role: the role's own, or where letters in it would be too faint to read, one between
/// it and that of other labels.
[[nodiscard]] Color labelColor(Role role, Theme theme);

/// What the figure is drawn on.
[[nodiscard]] Color paperColor(Theme theme);

/// The size of the letters of labels, and of their subscripts, which stand lower by kSubscriptDrop.
inline constexpr double kTextSize = 9;
inline constexpr double kSubscriptSize = 6.5;
inline constexpr double kSubscriptDrop = 2;
/// The fonts of labels, the first one that is there: serifs as in formulas, with Cyrillic letters.
inline constexpr std::string_view kTextFamily = "STIX Two Text, Times New Roman, Liberation Serif, Nimbus Roman, serif";

inline constexpr double kMillimetresPerPoint = 25.4 / 72;

} // namespace kriva
