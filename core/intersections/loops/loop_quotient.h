#pragma once

#include "core/intersections/contacts/arc.h"

namespace kriva {

/// A place in the plane of two parameters t = m - h and s = m + h of one segment: u = m - 1/2 and v = h^2.
struct LoopPlace {
    double u = 0;
    double v = 0;
};

/// (B(s) - B(t)) / (s - t), which vanishes where a segment meets itself, as a polynomial in u and v:
/// terms[power of u][power of v].
struct LoopQuotient {
    std::array<std::array<Vector, 3>, Arc::kMostDegree> terms{};
};

[[nodiscard]] LoopQuotient loopQuotientOf(const Arc& arc);

struct LoopValue {
    Vector value;
    Vector byU; ///< its derivatives
    Vector byV;
};
[[nodiscard]] LoopValue evaluate(const LoopQuotient& quotient, LoopPlace place);

/// The quotient in a rectangle around a place: in powers of the distances from there, and the largest of these. Bounds
/// take all terms by their absolute values.
struct LocalQuotient {
    LoopQuotient quotient;
    double u = 0;
    double v = 0;
};
[[nodiscard]] LocalQuotient around(const LoopQuotient& quotient, LoopPlace centre, double u, double v);

/// Whether the component along a direction surely vanishes nowhere in the rectangle.
[[nodiscard]] bool hasNoRoot(const LocalQuotient& local, Vector along);

/// How far the derivatives in the rectangle are from those in its centre at most, by each coordinate.
[[nodiscard]] Vector deviationByU(const LocalQuotient& local);
[[nodiscard]] Vector deviationByV(const LocalQuotient& local);

} // namespace kriva
