#include "core/bezier/nearest.h"

#include "core/bezier/evaluate.h"
#include "core/geometry/box.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// Half the derivative of the squared distance, (B - p) . B', up to the factor of the degree.
std::vector<double> approach(std::span<const Point> curve, Point point) {
    std::vector<double> x, y, dx, dy;
    for (const Point b : curve) {
        x.push_back(b.x - point.x);
        y.push_back(b.y - point.y);
    }
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        dx.push_back(curve[i + 1].x - curve[i].x);
        dy.push_back(curve[i + 1].y - curve[i].y);
    }
    std::vector<double> sum = product(x, dx);
    const std::vector<double> other = product(y, dy);
    std::ranges::transform(sum, other, sum.begin(), std::plus());
    return sum;
}

/// The root near t by Newton's method on the curve itself, which is more exact than the coefficients of the product.
double polished(std::span<const Point> curve, Point point, double t) {
    for (int step = 0; step < 2; ++step) {
        const Vector gap = evaluate(curve, t) - point;
        const Vector velocity = derivative(curve, t);
        const double slope = dot(velocity, velocity) + dot(gap, secondDerivative(curve, t));
        if (slope <= 0)
            break;
        t = std::clamp(t - dot(gap, velocity) / slope, 0.0, 1.0);
    }
    return t;
}

} // namespace

NearestPoint nearest(std::span<const Point> curve, Point point) {
    assert(!curve.empty());
    NearestPoint best{0, curve.front(), distance(curve.front(), point)};
    const auto consider = [&](double t) {
        const Point at = evaluate(curve, t);
        const double away = distance(at, point);
        if (away < best.distance)
            best = {t, at, away};
    };
    if (curve.size() > 1)
        for (const double t : signChanges(approach(curve, point))) {
            consider(t);
            consider(polished(curve, point, t));
        }
    consider(1);
    return best;
}

double leastDistance(std::span<const Point> curve, Point point) {
    const Box box = boxOf(curve);
    return std::hypot(std::max({box.xmin - point.x, 0.0, point.x - box.xmax}),
                      std::max({box.ymin - point.y, 0.0, point.y - box.ymax}));
}

} // namespace kriva
