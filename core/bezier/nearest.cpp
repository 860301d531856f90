#include "core/bezier/nearest.h"

#include "core/bezier/elevate.h"
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

/// The best place so far, from the start of the curve on.
class Best {
  public:
    Best(std::span<const Point> curve, Point point)
        : curve_(curve)
        , point_(point)
        , place_{0, curve.front(), distance(curve.front(), point)} {}

    void consider(double t) {
        const Point at = evaluate(curve_, t);
        // Told without a root in most cases.
        const Vector gap = at - point_;
        if (dot(gap, gap) > kSurely * place_.distance * place_.distance)
            return;
        const double away = distance(at, point_);
        if (away < place_.distance)
            place_ = {t, at, away};
    }
    [[nodiscard]] const NearestPoint& place() const { return place_; }

  private:
    static constexpr double kSurely = 1 + 1e-12;

    std::span<const Point> curve_;
    Point point_;
    NearestPoint place_;
};

NearestPoint nearestOfAnyCurve(std::span<const Point> curve, Point point) {
    Best best(curve, point);
    for (const double t : signChanges(approach(curve, point))) {
        best.consider(t);
        best.consider(polished(curve, point, t));
    }
    best.consider(1);
    return best.place();
}

/// A curve of degree 1 to 3, told as a cubic, for the search from many points.
class ShortCurve {
  public:
    explicit ShortCurve(std::span<const Point> curve)
        : curve_(curve) {
        Point cubic[4];
        elevate(curve, cubic);
        const Vector c1 = cubic[1] - cubic[0], c2 = cubic[2] - cubic[0], c3 = cubic[3] - cubic[0];
        const Vector d0 = c1, d1 = c2 - c1, d2 = c3 - c2;
        linear_ = 3 * d0;
        square_ = 3 * (d1 - d0);
        cube_ = (d2 - d1) - (d1 - d0);
        for (const Vector v : {linear_, square_, cube_})
            size_ += 3 * (std::abs(v.x) + std::abs(v.y));
        velocity_ = {
            d0, (3 * d0 + 2 * d1) / 5, (3 * d0 + 6 * d1 + d2) / 10, (d0 + 6 * d1 + 3 * d2) / 10, (2 * d1 + 3 * d2) / 5,
            d2};
        slope_ = {0,
                  3 * dot(c1, d0) / 5,
                  (6 * dot(c1, d1) + 3 * dot(c2, d0)) / 10,
                  (3 * dot(c1, d2) + 6 * dot(c2, d1) + dot(c3, d0)) / 10,
                  (3 * dot(c2, d2) + 2 * dot(c3, d1)) / 5,
                  dot(c3, d2)};
    }

    [[nodiscard]] NearestPoint nearestTo(Point point) const {
        Best best(curve_, point);
        const Vector toPoint = point - curve_.front();
        Slope slope;
        for (std::size_t k = 0; k < slope.size(); ++k)
            slope[k] = slope_[k] - dot(toPoint, velocity_[k]);
        const SignWalk walk(std::span<const double>(slope), 0, [&](const IsolatedChange<double>& change) {
            // Where the slope falls, the distance is greatest.
            if (change.sign > 0 || change.coefficients.empty())
                best.consider(rootIn(change, toPoint));
        });
        best.consider(1);
        return best.place();
    }

  private:
    /// The coefficients, of degree 5, of (B - p) . B', a third of half the derivative of the squared distance.
    using Slope = std::array<double, 6>;

    /// Where the control polygon crosses zero: near the root, and away from ends where the slope may be zero too.
    [[nodiscard]] static double startIn(const IsolatedChange<double>& change) {
        const std::span<const double> c = change.coefficients;
        for (std::size_t i = 1; i < c.size(); ++i)
            if (c[i - 1] * change.sign < 0 && c[i] * change.sign >= 0) {
                const double share =
                    (static_cast<double>(i - 1) + c[i - 1] / (c[i - 1] - c[i])) / static_cast<double>(c.size() - 1);
                return change.from + (change.to - change.from) * share;
            }
        return change.from / 2 + change.to / 2;
    }

    /// The slope at t, and how it grows there.
    struct SlopeAt {
        double value = 0;
        double growth = 0;
    };
    [[nodiscard]] SlopeAt slopeAt(double t, Vector toPoint) const {
        const Vector gap = t * (linear_ + t * (square_ + t * cube_)) - toPoint;
        const Vector velocity = linear_ + t * (2 * square_ + 3 * t * cube_);
        return {dot(gap, velocity), dot(velocity, velocity) + dot(gap, 2 * square_ + 6 * t * cube_)};
    }

    /// The root, by Newton's method that a halving helps where it leaves what is known of the root.
    [[nodiscard]] double rootIn(const IsolatedChange<double>& change, Vector toPoint) const {
        const double noise = noiseOf(toPoint);
        double low = change.from;
        double high = change.to;
        double t = startIn(change);
        for (int step = 0; step < kMostSteps; ++step) {
            const SlopeAt slope = slopeAt(t, toPoint);
            if (std::abs(slope.value) > noise)
                (slope.value < 0 ? low : high) = t;
            const double next = t - slope.value / slope.growth;
            if (slope.growth > 0 && low <= next && next <= high) {
                // The step after a short one would be shorter than a rounding.
                if (std::abs(next - t) <= kShortStep)
                    return next;
                t = next;
            } else {
                const double middle = low / 2 + high / 2;
                if (middle == t)
                    break;
                t = middle;
            }
        }
        return creptFrom(t, toPoint);
    }

    /// Where roots fall together, the coefficients tell less of the place than the curve does: Newton's method goes on
    /// as long as its steps become shorter.
    [[nodiscard]] double creptFrom(double t, Vector toPoint) const {
        double last = 1;
        for (int step = 0; step < kMostSteps && last > kShortStep; ++step) {
            const SlopeAt slope = slopeAt(t, toPoint);
            const double next = std::clamp(t - slope.value / slope.growth, 0.0, 1.0);
            if (!(slope.growth > 0 && std::abs(next - t) < last))
                break;
            last = std::abs(next - t);
            t = next;
        }
        return t;
    }

    /// What the roundings of a slope may come to.
    [[nodiscard]] double noiseOf(Vector toPoint) const {
        const double size = size_ + std::abs(toPoint.x) + std::abs(toPoint.y);
        return kRoundings * size * size_;
    }

    static constexpr double kRoundings = 0x1p-48;
    static constexpr int kMostSteps = 100;
    static constexpr double kShortStep = 0x1p-30;

    std::span<const Point> curve_;
    Vector linear_; ///< B in powers of t, from its start
    Vector square_;
    Vector cube_;
    double size_ = 0;                ///< no coordinate of B or its derivatives is larger
    std::array<Vector, 6> velocity_; ///< a third of B', raised to degree 5
    Slope slope_;                    ///< from the start of the curve
};

// Above, the search is another one.
constexpr std::size_t kLongestShort = 4;

} // namespace

NearestPoint nearest(std::span<const Point> curve, Point point) {
    NearestPoint place;
    nearest(curve, std::span(&point, 1), std::span(&place, 1));
    return place;
}

void nearest(std::span<const Point> curve, std::span<const Point> points, std::span<NearestPoint> places) {
    assert(!curve.empty() && places.size() == points.size());
    if (curve.size() == 1)
        std::ranges::transform(points, places.begin(), [&](Point p) {
            return NearestPoint{0, curve.front(), distance(curve.front(), p)};
        });
    else if (curve.size() <= kLongestShort)
        std::ranges::transform(points, places.begin(),
                               [search = ShortCurve(curve)](Point p) { return search.nearestTo(p); });
    else
        std::ranges::transform(points, places.begin(), [&](Point p) { return nearestOfAnyCurve(curve, p); });
}

double leastDistance(std::span<const Point> curve, Point point) {
    const Box box = boxOf(curve);
    return std::hypot(std::max({box.xmin - point.x, 0.0, point.x - box.xmax}),
                      std::max({box.ymin - point.y, 0.0, point.y - box.ymax}));
}

} // namespace kriva
