#pragma once

#include <vector>

namespace kriva {

/// A polynomial over an interval of length `width`, by its Bernstein coefficients (at least one).
struct BernsteinPiece {
    std::vector<double> coefficients;
    double width = 0;
};

/// The sum over the pieces of the integral of |f|, 1e-11 relative; not finite where a coefficient is not.
/// Each integral lies between |mean of the coefficients| and mean of their absolute values, times the width; pieces
/// where these differ, those around the roots of f, are halved until the sum is known.
[[nodiscard]] double absoluteIntegral(std::vector<BernsteinPiece> pieces);

} // namespace kriva
