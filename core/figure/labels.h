#pragma once

#include "core/figure/figure.h"

namespace kriva {

/// Of a curve with more of them labels would cover each other and the curve, and take longer to lay out than everything
/// else.
inline constexpr std::size_t kMostLabelledPoints = 1000;

/// letter_0, letter_1, ... beside the points.
[[nodiscard]] std::vector<Label> indexedLabels(std::string_view letter, std::span<const Point> points,
                                               Role role = Role::label);

/// A whole number in decimal digits.
[[nodiscard]] std::string decimal(int number);

} // namespace kriva
