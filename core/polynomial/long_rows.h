#pragma once

#include "core/geometry/point.h"

#include <array>

/// De Casteljau's and Horner's schemes on rows of many coefficients by the widest registers that the processor has: to
/// the last bit what casteljau.h and bernstein_polynomial.h, which call them, do with short rows.
namespace kriva {

/// Coefficients from which on a row is long.
inline constexpr std::size_t kLongRow = 16;

/// splitInPlace() of a long row.
void splitLongRow(std::span<double> row, std::span<double> left, double t);
void splitLongRow(std::span<Vector> row, std::span<Vector> left, double t);

/// Numbers at which a long row is evaluated together: as many as keep the processor busy.
inline constexpr std::size_t kTogetherInLongRow = 8;
using ManyRatios = std::array<double, kTogetherInLongRow>;
using ManyVectors = std::array<Vector, kTogetherInLongRow>;

/// Horner's scheme at each ratio: `near` begins with the last entry and ends with the first, `far` the other way round.
void evaluateLongRow(std::span<const Vector> row, const ManyRatios& ratios, ManyVectors& near, ManyVectors& far);

} // namespace kriva
