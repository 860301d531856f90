#include "core/sheets/spline/chain/continuity.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

/// The contract's threshold for everything below, relative to the longer polygon.
constexpr double kAgree = 1e-9;

double polygonLength(std::span<const Point> polygon) {
    double sum = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
        sum += distance(polygon[i - 1], polygon[i]);
    return sum;
}

/// The first two derivatives at one end, in units of the longer polygon.
struct Jet {
    Vector first;
    Vector second;
};

/// The jet of a polygon that starts with these points, whose degree is given.
Jet jetOf(Point p0, Point p1, Point p2, double degree, double unit) {
    const Vector first = (p1 - p0) / unit;
    const Vector next = (p2 - p1) / unit;
    return {degree * first, degree * (degree - 1) * (next - first)};
}

Jet startJet(std::span<const Point> p, double unit) {
    const std::size_t degree = p.size() - 1;
    return jetOf(p[0], p[1], p[std::min<std::size_t>(2, degree)], static_cast<double>(degree), unit);
}

Jet endJet(std::span<const Point> p, double unit) {
    const std::size_t n = p.size() - 1;
    const Jet backwards = jetOf(p[n], p[n - 1], p[n - std::min<std::size_t>(2, n)], static_cast<double>(n), unit);
    return {-backwards.first, backwards.second};
}

double curvatureOf(const Jet& jet) {
    const double speed = length(jet.first);
    return cross(jet.first / speed, jet.second) / speed / speed;
}

bool agree(Vector a, Vector b) {
    return length(b - a) <= kAgree;
}

bool haveSameDirection(Vector a, Vector b) {
    const double lengthA = length(a);
    const double lengthB = length(b);
    if (std::min(lengthA, lengthB) <= kAgree)
        return false;
    return dot(a, b) > 0 && std::abs(cross(a / lengthA, b / lengthB)) <= kAgree;
}

bool haveSameCurvature(const Jet& a, const Jet& b) {
    const double before = curvatureOf(a);
    const double after = curvatureOf(b);
    return std::abs(after - before) <= kAgree * std::max({std::abs(before), std::abs(after), 1.0});
}

} // namespace

std::string_view nameOf(Continuity continuity) {
    switch (continuity) {
    case Continuity::c2:
        return "C2";
    case Continuity::g2:
        return "G2";
    case Continuity::c1:
        return "C1";
    case Continuity::g1:
        return "G1";
    case Continuity::c0:
        return "C0";
    case Continuity::end:
        break;
    }
    return "end";
}

Continuity continuityBetween(std::span<const Point> arriving, std::span<const Point> leaving) {
    assert(arriving.size() >= 2 && leaving.size() >= 2);
    const double unit = std::max(polygonLength(arriving), polygonLength(leaving));
    if (unit == 0)
        return Continuity::c2;
    const Jet before = endJet(arriving, unit);
    const Jet after = startJet(leaving, unit);
    const bool isC1 = agree(before.first, after.first);
    if (isC1 && agree(before.second, after.second))
        return Continuity::c2;
    const bool isG1 = haveSameDirection(before.first, after.first);
    if (isG1 && haveSameCurvature(before, after))
        return Continuity::g2;
    if (isC1)
        return Continuity::c1;
    return isG1 ? Continuity::g1 : Continuity::c0;
}

} // namespace kriva
