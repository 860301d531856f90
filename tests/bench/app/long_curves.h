#pragma once

#include "core/document/document.h"

#include <cmath>

namespace kriva::test {

/// A spiral with waves on it: long, and crossing itself now and then.
inline Points spiral(int count) {
    Points points;
    for (int i = 0; i < count; ++i) {
        const double t = i / 20.0;
        const double radius = 10 + t + 3 * std::sin(7 * t);
        points.push_back({radius * std::cos(t), radius * std::sin(t)});
    }
    return points;
}

inline Curve splineThrough(const Points& points, SplineCurve::Rule rule) {
    SplineCurve curve;
    curve.rule = rule;
    for (const Point at : points)
        curve.knots.push_back({at, {}, {}, {}});
    return Curve(std::move(curve));
}

inline Curve combinedThrough(const Points& points) {
    CombinedCurve curve;
    curve.points = points;
    return Curve(std::move(curve));
}

/// A document with this curve alone, in whose sheet it opens.
inline Document documentOf(const Curve& curve) {
    Document document;
    document.active = curve.index();
    document.sheets[curve.index()].curves = {curve};
    return document;
}

} // namespace kriva::test
