#include "core/bezier/evaluate.h"

#include "core/polynomial/casteljau.h"

#include <cassert>

namespace kriva {

Point evaluate(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    // The way back from vectors rounds, and the ends are promised exactly.
    if (t == 0)
        return curve.front();
    if (t == 1)
        return curve.back();
    RowBuffer<Vector> buffer(curve.size());
    writeFromStart(curve, buffer.row());
    return curve.front() + valueInPlace(buffer.row(), t);
}

Vector derivative(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    if (curve.size() < 2)
        return {};
    const std::size_t degree = curve.size() - 1;
    RowBuffer<Vector> buffer(degree);
    for (std::size_t i = 0; i < degree; ++i)
        buffer.row()[i] = curve[i + 1] - curve[i];
    return static_cast<double>(degree) * valueInPlace(buffer.row(), t);
}

Vector secondDerivative(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    if (curve.size() < 3)
        return {};
    const std::size_t degree = curve.size() - 1;
    RowBuffer<Vector> buffer(degree - 1);
    for (std::size_t i = 0; i + 1 < degree; ++i)
        buffer.row()[i] = (curve[i + 2] - curve[i + 1]) - (curve[i + 1] - curve[i]);
    return static_cast<double>(degree * (degree - 1)) * valueInPlace(buffer.row(), t);
}

std::vector<Vector> hodograph(std::span<const Point> curve) {
    assert(!curve.empty());
    const auto degree = static_cast<double>(curve.size() - 1);
    std::vector<Vector> vectors;
    vectors.reserve(curve.size() - 1);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        vectors.push_back(degree * (curve[i + 1] - curve[i]));
    return vectors;
}

std::vector<double> bernstein(int degree, double t) {
    assert(degree >= 0);
    std::vector<double> values(static_cast<std::size_t>(degree) + 1, 0.0);
    values[0] = 1;
    for (std::size_t k = 1; k < values.size(); ++k) {
        for (std::size_t i = k; i > 0; --i)
            values[i] = (1 - t) * values[i] + t * values[i - 1];
        values[0] *= 1 - t;
    }
    return values;
}

} // namespace kriva
