#pragma once

#include "core/geometry/point.h"

/// De Casteljau's scheme on rows of many coefficients by the widest registers that the processor has: to the last bit
/// what casteljau.h, which calls it, does with short rows.
namespace kriva {

/// Coefficients from which on a row is long.
inline constexpr std::size_t kLongRow = 16;

/// splitInPlace() of a long row.
void splitLongRow(std::span<double> row, std::span<double> left, double t);
void splitLongRow(std::span<Vector> row, std::span<Vector> left, double t);

} // namespace kriva
