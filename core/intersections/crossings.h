#pragma once

#include "core/budget/work_budget.h"
#include "core/geometry/point.h"

#include <array>

namespace kriva {

/// Segments of degree 1 to 5, each starting where the one before ended; the last ends where the first starts if closed.
struct SegmentChain {
    std::span<const Points> segments;
    bool closed = false;
};

/// A curve at a place.
struct Pass {
    std::size_t curve = 0;
    std::size_t segment = 0;
    double t = 0;
    friend constexpr auto operator<=>(const Pass&, const Pass&) = default;
};

/// A place where curves cross or touch themselves or each other.
struct Crossing {
    Point at;
    std::vector<Pass> passes; ///< at least two, ascending
};

/// A part of a segment.
struct PassedPart {
    std::size_t curve = 0;
    std::size_t segment = 0;
    double from = 0;
    double to = 1;
};

/// A stretch along which two segments lie on each other: the first with from < to, the second at the same two places.
struct Overlap {
    std::array<PassedPart, 2> passes;
};

struct Crossings {
    std::vector<Crossing> places; ///< by their first pass
    std::vector<Overlap> overlaps;
};

/// All places where the chains meet themselves or each other, each once, and the stretches that they share.
///
/// Meetings closer than 1e-9 of the diagonal of the chains' bounds are one place, curves within 1e-12 of it meet. The
/// knot between neighbouring segments is no crossing, a cusp neither. A pass through a knot is told at t = 0 of the
/// segment that starts there. Segments of one point take no part, straight ones that turn back neither. Parameters are
/// right to 1e-7, 1e-6 where curves touch; places to 1e-9 of the diagonal.
///
/// Nothing where the budget has ended; it ends as WorkEnd::tooMuchFound beyond `mostPasses`, of places and of overlaps
/// together. O(n log n + pairs of boxes that overlap), each pair by SegmentContacts, each segment alone by
/// doublePoints.
[[nodiscard]] std::optional<Crossings> findCrossings(std::span<const SegmentChain> chains, WorkBudget& budget,
                                                     std::size_t mostPasses);
/// The same without limits.
[[nodiscard]] Crossings findCrossings(std::span<const SegmentChain> chains);

} // namespace kriva
