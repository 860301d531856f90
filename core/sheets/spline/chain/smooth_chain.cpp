#include "core/sheets/spline/chain/smooth_chain.h"

#include "core/geometry/compensated_sum.h"

namespace kriva {
namespace {

/// Compensated: a chain that goes to and fro by equal steps would else gather equal roundings.
class VectorSum {
  public:
    void add(Vector term) {
        x_.add(term.x);
        y_.add(term.y);
    }
    [[nodiscard]] Vector value() const { return {x_.value(), y_.value()}; }

  private:
    CompensatedSum x_;
    CompensatedSum y_;
};

} // namespace

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

// Let w_i be P1 of segment i seen from the midpoint of its chord; then P0 - 2 P1 + P2 = -2 w_i, and the mirror images
// ask for w_i = (c_(i-1) - c_i) / 2 - w_(i-1). With alternating signs u_i = (-1)^i w_i this is a running sum
// u_i = u_0 + g_i, and the sum of |u_0 + g_i|^2 is least where u_0 is minus the mean of the g_i.
std::vector<Vector> quadraticMiddles(std::span<const Vector> chords) {
    const std::size_t n = chords.size();
    std::vector<Vector> middles(n);
    VectorSum running;
    VectorSum total;
    for (std::size_t i = 1; i < n; ++i) {
        const Vector step = (chords[i - 1] - chords[i]) / 2;
        running.add(i % 2 == 0 ? step : -step);
        middles[i] = running.value();
        total.add(middles[i]);
    }
    const Vector mean = total.value() / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vector alternating = middles[i] - mean;
        middles[i] = chords[i] / 2 + (i % 2 == 0 ? alternating : -alternating);
    }
    return middles;
}

} // namespace kriva
