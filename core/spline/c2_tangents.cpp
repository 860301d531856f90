#include "core/spline/c2_tangents.h"

namespace kriva {

// Elimination without pivoting (Thomas): every row is strictly diagonally dominant (4 > 1 + 1, 2 > 1, 1 > 0), so all
// pivots stay above 1, all multipliers below 1, and errors are damped from row to row.
std::vector<Vector> c2Tangents(std::span<const Vector> chords, std::optional<Vector> start, std::optional<Vector> end) {
    const std::size_t n = chords.size();
    std::vector<Vector> h(n + 1);
    std::vector<double> upper(n + 1);
    upper[0] = start ? 0 : 0.5;
    h[0] = start ? *start : chords[0] / 2;
    for (std::size_t i = 1; i < n; ++i) {
        const double pivot = 4 - upper[i - 1];
        upper[i] = 1 / pivot;
        h[i] = (chords[i - 1] + chords[i] - h[i - 1]) / pivot;
    }
    h[n] = end ? *end : (chords[n - 1] - h[n - 1]) / (2 - upper[n - 1]);
    for (std::size_t i = n; i-- > 0;)
        h[i] = h[i] - upper[i] * h[i + 1];
    return h;
}

// Cut open at K_0, the chain is a run clamped to h_0 at both ends, and depends on h_0 linearly: h_i = p_i + q_i h_0
// with p the run clamped to zero and q the solution of q_(i-1) + 4 q_i + q_(i+1) = 0, q_0 = q_n = 1, which is
// q_i = (r^i + r^(n-i)) / (1 + r^n) for the root r of r^2 + 4 r + 1 inside the unit circle. The row of K_0 then gives
// h_0; its pivot 4 + q_1 + q_(n-1) lies between 3 and 4.
std::vector<Vector> periodicC2Tangents(std::span<const Vector> chords) {
    const std::size_t n = chords.size();
    const std::vector<Vector> p = c2Tangents(chords, Vector{}, Vector{});
    const double root = -1 / (2 + std::sqrt(3.0));
    const double q1 =
        (root + std::pow(root, static_cast<double>(n - 1))) / (1 + std::pow(root, static_cast<double>(n)));
    const Vector h0 = (chords[n - 1] + chords[0] - p[1] - p[n - 1]) / (4 + 2 * q1);
    return c2Tangents(chords, h0, h0);
}

} // namespace kriva
