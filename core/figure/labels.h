#pragma once

#include "core/figure/figure.h"

namespace kriva {

/// letter_0, letter_1, ... beside the points.
[[nodiscard]] std::vector<Label> indexedLabels(std::string_view letter, std::span<const Point> points,
                                               Role role = Role::label);

/// A whole number in decimal digits.
[[nodiscard]] std::string decimal(int number);

} // namespace kriva
