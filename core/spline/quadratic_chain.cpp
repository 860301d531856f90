#include "core/spline/quadratic_chain.h"

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
