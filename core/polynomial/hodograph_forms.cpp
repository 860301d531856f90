#include "core/polynomial/hodograph_forms.h"

#include "core/polynomial/bernstein_polynomial.h"

#include <algorithm>
#include <cassert>

namespace kriva {

double unitOf(std::span<const Point> curve) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vector side = curve[i + 1] - curve[i];
        largest = std::max({largest, std::abs(side.x), std::abs(side.y)});
    }
    return largest > 0 ? std::exp2(std::ilogb(largest)) : 1;
}

template <class T>
Hodograph<T> hodographIn(double unit, std::span<const Point> curve) {
    assert(curve.size() >= 2);
    const T degree(static_cast<double>(curve.size() - 1));
    const T factor(1 / unit);
    Hodograph<T> result;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        result.x.push_back(degree * (factor * (T(curve[i + 1].x) - T(curve[i].x))));
        result.y.push_back(degree * (factor * (T(curve[i + 1].y) - T(curve[i].y))));
    }
    return result;
}

template <class T>
std::vector<T> turning(const Hodograph<T>& hodograph) {
    const std::size_t degree = hodograph.x.size() - 1;
    if (degree == 0)
        return {T(0.0)};
    // With the two points a, b of the last step of de Casteljau's scheme, c = (1 - t) a + t b and c' = degree (b - a),
    // so that c x c' = degree (a x b).
    const auto first = [&](const std::vector<T>& c) { return std::span(c).first(degree); };
    const auto second = [&](const std::vector<T>& c) { return std::span(c).last(degree); };
    std::vector<T> result = product(first(hodograph.x), second(hodograph.y));
    const std::vector<T> other = product(first(hodograph.y), second(hodograph.x));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = T(static_cast<double>(degree)) * (result[i] - other[i]);
    return result;
}

template <class T>
std::vector<T> speedSquared(const Hodograph<T>& hodograph) {
    std::vector<T> result = product(std::span(hodograph.x), std::span(hodograph.x));
    const std::vector<T> other = product(std::span(hodograph.y), std::span(hodograph.y));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = result[i] + other[i];
    return result;
}

template Hodograph<double> hodographIn(double, std::span<const Point>);
template Hodograph<DoubleDouble> hodographIn(double, std::span<const Point>);
template std::vector<double> turning(const Hodograph<double>&);
template std::vector<DoubleDouble> turning(const Hodograph<DoubleDouble>&);
template std::vector<double> speedSquared(const Hodograph<double>&);
template std::vector<DoubleDouble> speedSquared(const Hodograph<DoubleDouble>&);

Spread spreadOf(std::span<const Vector> hodograph) {
    const Vector start = hodograph.front();
    const Vector way = hodograph.back() - start;
    double rest = 0;
    for (std::size_t i = 1; i + 1 < hodograph.size(); ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(hodograph.size() - 1);
        const Vector off = hodograph[i] - start - t * way;
        rest = std::max(rest, dot(off, off));
    }
    return {size(start + way / 2), size(way) / 2, std::sqrt(rest)};
}

} // namespace kriva
