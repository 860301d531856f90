#include "core/bezier/bounds.h"

#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>

namespace kriva {

Box tightBounds(std::span<const Point> curve) {
    if (curve.empty())
        return {};
    // Measured from the start, so that a far curve keeps its digits.
    const Point start = curve.front();
    RowBuffer<double> buffer(curve.size());
    const auto spanOf = [&](double Point::*coordinate) {
        const double from = start.*coordinate;
        std::ranges::transform(curve, buffer.row().begin(), [&](Point p) { return p.*coordinate - from; });
        const Range range = rangeOf(buffer.row());
        // The end is no extreme of the inside, and the way back from differences would round it.
        const double end = buffer.row().back();
        return Range{range.low == end ? curve.back().*coordinate : from + range.low,
                     range.high == end ? curve.back().*coordinate : from + range.high};
    };
    const Range x = spanOf(&Point::x);
    const Range y = spanOf(&Point::y);
    return {x.low, y.low, x.high, y.high};
}

} // namespace kriva
