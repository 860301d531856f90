#pragma once

#include <vector>

/// The round numbers at which grids, rulers and the axes of plots have their lines.
namespace kriva {

/// The least 1, 2 or 5 times a power of ten that is not below `least`, which is positive.
[[nodiscard]] double roundStep(double least);
/// Enough decimals to tell the multiples of a step apart.
[[nodiscard]] int decimalsOf(double step);
/// The multiples of `step` from `low` to `high`, ascending; at most 10,000.
[[nodiscard]] std::vector<double> multiples(double step, double low, double high);

} // namespace kriva
