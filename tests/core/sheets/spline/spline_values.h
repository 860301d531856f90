#pragma once

#include "core/sheets/spline/chain/spline_curve.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

/// Spline curves for tests.
namespace kriva::test {

inline SplineCurve curveThrough(SplineCurve::Rule rule, const Points& knots, bool closed = false, int degree = 3) {
    SplineCurve curve;
    curve.rule = rule;
    curve.closed = closed;
    curve.degree = degree;
    for (const Point at : knots)
        curve.knots.push_back({at, {}, {}, {}});
    return curve;
}

inline SplineKnot heldKnot(Point at, SplineKnot::Join join, std::optional<Point> in, std::optional<Point> out) {
    return {at, join, in, out};
}

/// At least as many points as asked for.
inline rc::Gen<Points> anyPoints(std::size_t atLeast) {
    return rc::gen::withSize(
        [=](int size) { return rc::gen::container<Points>(atLeast + static_cast<std::size_t>(size) / 4, anyPoint()); });
}

inline rc::Gen<SplineCurve::Rule> anyRule() {
    return rc::gen::element(SplineCurve::Rule::mirror, SplineCurve::Rule::natural, SplineCurve::Rule::clamped,
                            SplineCurve::Rule::catmullRom);
}

inline rc::Gen<SplineKnot::Join> anyJoin() {
    return rc::gen::element(SplineKnot::Join::automatic, SplineKnot::Join::automatic, SplineKnot::Join::symmetric,
                            SplineKnot::Join::smooth, SplineKnot::Join::corner);
}

/// Any complete curve: every rule, degree and join, stored handles anywhere, coincident knots now and then.
inline SplineCurve anySpline() {
    SplineCurve curve = curveThrough(*anyRule(), *anyPoints(3), *rc::gen::arbitrary<bool>(), *rc::gen::inRange(2, 6));
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
        SplineKnot& knot = curve.knots[i];
        if (i > 0 && *rc::gen::inRange(0, 10) == 0)
            knot.at = curve.knots[i - 1].at;
        knot.join = *anyJoin();
        if (knot.join != SplineKnot::Join::automatic || *rc::gen::inRange(0, 4) == 0) {
            knot.in = *anyPoint();
            knot.out = *anyPoint();
        }
    }
    if (*rc::gen::arbitrary<bool>())
        curve.startDerivative = *anyPoint() - Point{};
    if (*rc::gen::arbitrary<bool>())
        curve.endDerivative = *anyPoint() - Point{};
    for (int i = 0; i < static_cast<int>(segmentCount(curve)); ++i)
        if (innerCount(curve.degree) > 0 && *rc::gen::inRange(0, 3) == 0)
            curve.inner[i] = *rc::gen::container<Points>(innerCount(curve.degree), anyPoint());
    return curve;
}

/// The largest coordinate-wise distance between two lists of segments; infinite where their shapes differ.
inline double farthest(const std::vector<Points>& a, const std::vector<Points>& b) {
    const double infinite = std::numeric_limits<double>::infinity();
    if (a.size() != b.size())
        return infinite;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].size() != b[i].size())
            return infinite;
        for (std::size_t j = 0; j < a[i].size(); ++j)
            most = std::max({most, std::abs(a[i][j].x - b[i][j].x), std::abs(a[i][j].y - b[i][j].y)});
    }
    return most;
}

} // namespace kriva::test
