#pragma once

#include "core/bezier/cubic_pieces.h"
#include "core/figure/figure.h"
#include "core/figure/style/page.h"

namespace kriva {

/// How far a cubic that stands for a piece of degree 4 and above may be from it, in millimetres.
inline constexpr double kCubicTolerance = 0.001;

/// Calls visit(std::span<const Point>) for each Bézier curve of degree 1 to 3 that draws the path, in millimetres of
/// the page: its pieces themselves, and for those of higher degrees cubics within kCubicTolerance. Each starts where
/// the one before it ended.
template <class Visit>
void forEachDrawnPiece(const Path& path, const Page& page, Visit visit) {
    Points points;
    forEachPiece(path, [&](std::span<const Point> piece) {
        if (piece.size() < 2)
            return;
        points.clear();
        for (const Point p : piece)
            points.push_back(onPage(page, p));
        if (points.size() <= 4)
            return visit(std::span<const Point>(points));
        for (const Cubic& cubic : cubicPieces(points, {kCubicTolerance}))
            visit(std::span<const Point>(cubic));
    });
}

} // namespace kriva
