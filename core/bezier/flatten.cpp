#include "core/bezier/flatten.h"

#include "core/geometry/box.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// Halvings that reach the finest tolerance at any degree: each one divides the distance from the chord by four.
constexpr int kDeepest = 40;

/// Whether the chord may stand for a piece with these control vectors.
///
/// The piece stays in the hull of its control points, hence as near to the chord as they are; running from end to end
/// past every point of the chord, it also leaves none farther behind. Where all control points lie above the chord, the
/// inner ones, which alone are off its line, weigh together at most 1 - 2^(1 - n).
bool isFlat(std::span<const Vector> piece, double tolerance) {
    const Vector start = piece.front();
    const Vector chord = piece.back() - start;
    const double squared = dot(chord, chord);
    double farthest = 0;
    bool above = true;
    for (const Vector v : piece.subspan(1, piece.size() - 2)) {
        const double along = dot(v - start, chord);
        above = above && 0 <= along && along <= squared;
        const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
        const Vector off = v - start - share * chord;
        farthest = std::max(farthest, dot(off, off));
    }
    const double weight = above ? 1 - std::exp2(2 - static_cast<double>(piece.size())) : 1;
    return weight * std::sqrt(farthest) <= tolerance;
}

/// Appends the vertices after the first one; `piece`, control vectors from `origin`, is used up.
void append(Point origin, std::span<Vector> piece, double tolerance, int depth, Points& vertices) {
    if (depth == kDeepest || isFlat(piece, tolerance)) {
        vertices.push_back(origin + piece.back());
        return;
    }
    RowBuffer<Vector> left(piece.size());
    splitInPlace(piece, left.row(), 0.5);
    append(origin, left.row(), tolerance, depth + 1, vertices);
    append(origin, piece, tolerance, depth + 1, vertices);
}

} // namespace

Points flattened(std::span<const Point> curve, Tolerance tolerance) {
    assert(!curve.empty());
    Points vertices{curve.front()};
    if (curve.size() == 1)
        return vertices;
    RowBuffer<Vector> row(curve.size());
    writeFromStart(curve, row.row());
    const double finest = kFinestFlattening * diagonal(boxOf(curve));
    append(curve.front(), row.row(), std::max(tolerance.distance, finest), 0, vertices);
    vertices.back() = curve.back();
    return vertices;
}

} // namespace kriva
