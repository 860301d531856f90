#pragma once

#include <span>
#include <vector>

namespace kriva {

/// The parameters in the open interval (0, 1), ascending, where the polynomial with these Bernstein coefficients
/// changes its sign. Roots without a change are left out, roots closer than about 1e-15 count by their parity; where
/// the polynomial stays below its own rounding error the change lies in the middle of that stretch. The zero
/// polynomial has none. Isolated by subdivision and Descartes' rule of signs, then refined by bracketing: O(degree^2)
/// per root and halving.
/// Source: Lane, Riesenfeld, Bounds on a polynomial, BIT 21 (1981).
[[nodiscard]] std::vector<double> signChanges(std::span<const double> coefficients);

} // namespace kriva
