#include "core/bezier/flatten.h"

#include "core/bezier/subdivide.h"
#include "core/geometry/box.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// Halvings that reach the finest tolerance at any degree: each one divides the distance from the chord by four.
constexpr int kDeepest = 40;

double distanceToSegment(Point p, Point a, Point b) {
    const Vector chord = b - a;
    const double squared = dot(chord, chord);
    const double along = squared > 0 ? std::clamp(dot(p - a, chord) / squared, 0.0, 1.0) : 0;
    return length(p - a - along * chord);
}

/// Whether the chord may stand for the curve.
///
/// The curve stays in the hull of its control points, hence as near to the chord as they are; running from end to end
/// past every point of the chord, it also leaves none farther behind. Where all control points lie above the chord, the
/// inner ones, which alone are off its line, weigh together at most 1 - 2^(1 - n).
bool isFlat(std::span<const Point> curve, double tolerance) {
    const Point start = curve.front();
    const Vector chord = curve.back() - start;
    const double squared = dot(chord, chord);
    const auto inner = curve.subspan(1, curve.size() - 2);
    const bool above = std::ranges::all_of(inner, [&](Point p) {
        const double along = dot(p - start, chord);
        return 0 <= along && along <= squared;
    });
    const double weight = above ? 1 - std::exp2(2 - static_cast<double>(curve.size())) : 1;
    return std::ranges::all_of(
        inner, [&](Point p) { return weight * distanceToSegment(p, start, curve.back()) <= tolerance; });
}

void append(std::span<const Point> curve, double tolerance, int depth, Points& vertices) {
    if (depth == kDeepest || isFlat(curve, tolerance)) {
        vertices.push_back(curve.back());
        return;
    }
    const Halves halves = split(curve, 0.5);
    append(halves.left, tolerance, depth + 1, vertices);
    append(halves.right, tolerance, depth + 1, vertices);
}

} // namespace

Points flattened(std::span<const Point> curve, Tolerance tolerance) {
    assert(!curve.empty());
    Points vertices{curve.front()};
    if (curve.size() > 1)
        append(curve, std::max(tolerance.distance, kFinestFlattening * diagonal(boxOf(curve))), 0, vertices);
    return vertices;
}

} // namespace kriva
