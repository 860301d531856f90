#include "core/polynomial/hodograph_forms.h"

#include "core/polynomial/bernstein_polynomial.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

using Exact = std::vector<DoubleDouble>;

template <class Combine>
Exact combined(const Exact& a, const Exact& b, Combine combine) {
    Exact result;
    result.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        result.push_back(combine(a[i], b[i]));
    return result;
}

} // namespace

double unitOf(std::span<const Point> curve) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vector side = curve[i + 1] - curve[i];
        largest = std::max({largest, std::abs(side.x), std::abs(side.y)});
    }
    return largest > 0 ? std::exp2(std::ilogb(largest)) : 1;
}

ExactHodograph exactHodograph(std::span<const Point> curve, double unit) {
    assert(curve.size() >= 2);
    const DoubleDouble degree(static_cast<double>(curve.size() - 1));
    const DoubleDouble factor(1 / unit);
    ExactHodograph result;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        result.x.push_back(degree * (factor * exactSum(curve[i + 1].x, -curve[i].x)));
        result.y.push_back(degree * (factor * exactSum(curve[i + 1].y, -curve[i].y)));
    }
    return result;
}

std::vector<DoubleDouble> turning(const ExactHodograph& hodograph) {
    const std::size_t degree = hodograph.x.size() - 1;
    if (degree == 0)
        return {DoubleDouble()};
    // With the two points a, b of the last step of de Casteljau's scheme, c = (1 - t) a + t b and c' = degree (b - a),
    // so that c x c' = degree (a x b).
    const auto first = [&](const Exact& c) { return std::span(c).first(degree); };
    const auto second = [&](const Exact& c) { return std::span(c).last(degree); };
    return combined(product(first(hodograph.x), second(hodograph.y)), product(first(hodograph.y), second(hodograph.x)),
                    [&](const DoubleDouble& p, const DoubleDouble& q) {
                        return DoubleDouble(static_cast<double>(degree)) * (p - q);
                    });
}

std::vector<DoubleDouble> speedSquared(const ExactHodograph& hodograph) {
    return combined(product(hodograph.x, hodograph.x), product(hodograph.y, hodograph.y),
                    [](const DoubleDouble& p, const DoubleDouble& q) { return p + q; });
}

} // namespace kriva
