#include "core/bezier/pull.h"

#include "core/bezier/evaluate.h"

namespace kriva {
namespace {

// With less weight in all, the points would have to move more than a thousand times as far as the pointer.
constexpr double kLeastWeight = 1e-3;

} // namespace

std::optional<Points> pulled(std::span<const Point> curve, double t, Vector by) {
    if (curve.size() < 3)
        return {};
    const std::vector<double> weights = bernstein(static_cast<int>(curve.size()) - 1, t);
    double squares = 0;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
        squares += weights[i] * weights[i];
    if (squares < kLeastWeight * kLeastWeight)
        return {};
    Points moved(curve.begin(), curve.end());
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
        moved[i] = curve[i] + (weights[i] / squares) * by;
    return moved;
}

} // namespace kriva
