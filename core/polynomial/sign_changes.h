#pragma once

#include "core/numbers/double_double.h"

#include <optional>
#include <span>
#include <vector>

namespace kriva {

/// The parameters in the open interval (0, 1), ascending, where the polynomial with these Bernstein coefficients
/// changes its sign. Roots without a change are left out. Where its values drown in noise, the change lies in the
/// middle of that stretch, and several count by their parity. The zero polynomial has none.
///
/// Isolated by halving and Descartes' rule of signs, then refined by bracketing: O(degree^2) per root and halving.
/// Source: Lane, Riesenfeld, Bounds on a polynomial, BIT 21 (1981).
///
/// The noise is the rounding error of the work in doubles.
[[nodiscard]] std::vector<double> signChanges(std::span<const double> coefficients);

/// The same where every sign that counts stands out of the noise that the coefficients carry; else nothing.
[[nodiscard]] std::optional<std::vector<double>> certainSignChanges(std::span<const double> coefficients, double noise);

/// The same in double-double arithmetic, with the noise that the coefficients already carry.
[[nodiscard]] std::vector<double> signChanges(std::span<const DoubleDouble> coefficients, double noise);

} // namespace kriva
