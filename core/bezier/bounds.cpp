#include "core/bezier/bounds.h"

#include "core/bezier/bernstein_roots.h"
#include "core/bezier/casteljau.h"

#include <algorithm>

namespace kriva {

namespace {

struct Range {
    double low = 0;
    double high = 0;
};

/// The range of one coordinate over the inside of the curve. Its Bernstein coefficients are measured from the start,
/// so the first one is 0.
Range innerRange(std::span<const double> coefficients) {
    const auto [least, most] = std::minmax({0.0, coefficients.back()});
    // A curve lies in the hull of its control points: most pieces of a spline end here.
    if (std::ranges::all_of(coefficients, [&](double c) { return least <= c && c <= most; }))
        return {};
    RowBuffer<double> buffer(coefficients.size());
    const std::span<double> steps = buffer.row().first(coefficients.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = coefficients[i + 1] - coefficients[i];
    Range range;
    for (const double t : signChanges(steps)) {
        std::ranges::copy(coefficients, buffer.row().begin());
        const double value = valueInPlace(buffer.row(), t);
        range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

} // namespace

Box tightBounds(std::span<const Point> curve) {
    if (curve.empty())
        return {};
    const Point start = curve.front();
    RowBuffer<double> buffer(curve.size());
    const std::span<double> row = buffer.row();
    std::ranges::transform(curve, row.begin(), [&](Point p) { return p.x - start.x; });
    const Range x = innerRange(row);
    std::ranges::transform(curve, row.begin(), [&](Point p) { return p.y - start.y; });
    const Range y = innerRange(row);
    Box box{start.x + x.low, start.y + y.low, start.x + x.high, start.y + y.high};
    extend(box, curve.back());
    return box;
}

} // namespace kriva
