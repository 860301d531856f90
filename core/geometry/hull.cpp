#include "core/geometry/hull.h"

#include <algorithm>

namespace kriva {

namespace {

/// Whether b lies to the left of the way from a over to c, or on it: then b is no corner of a counterclockwise hull.
bool isIdle(Point a, Point b, Point c) {
    const Vector ab = b - a;
    const Vector ac = c - a;
    const double product = ab.x * ac.y;
    // cross(ab, ac) with one rounding: what the first product lost is put back.
    return std::fma(-ab.y, ac.x, product) + std::fma(ab.x, ac.y, -product) <= 0;
}

/// Appends the lower hull of points sorted from left to right, without its last corner.
template <class Iterator>
void appendChain(Iterator from, Iterator to, Points& hull) {
    const std::size_t start = hull.size();
    for (; from != to; ++from) {
        while (hull.size() >= start + 2 && isIdle(hull[hull.size() - 2], hull.back(), *from))
            hull.pop_back();
        hull.push_back(*from);
    }
    hull.pop_back();
}

} // namespace

Points convexHull(std::span<const Point> points) {
    Points sorted(points.begin(), points.end());
    std::ranges::sort(sorted, [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    const auto repeated = std::ranges::unique(sorted);
    sorted.erase(repeated.begin(), repeated.end());
    if (sorted.size() < 2)
        return sorted;
    Points hull;
    appendChain(sorted.begin(), sorted.end(), hull);
    appendChain(sorted.rbegin(), sorted.rend(), hull);
    return hull;
}

} // namespace kriva
