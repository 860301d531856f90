#pragma once

#include "core/budget/work_budget.h"
#include "core/intersections/contacts/arc.h"

#include <vector>

namespace kriva {

/// Distances below which places are not told apart, in the frame of the arcs.
struct ContactScale {
    double touching = 1e-12; ///< curves this close meet
    double place = 1e-9;     ///< meetings this close are one place
};

/// A segment whose contacts are sought, and its cusps: at the parameters in (0, 1) where its speed vanishes it may turn
/// back, so that no tangent tells where it goes.
struct CuspedArc {
    Arc arc;
    std::vector<double> cusps;
};

/// A segment of degree 1 to 5 in the frame, its cusps looked for.
[[nodiscard]] CuspedArc cuspedArcOf(std::span<const Point> segment, const ArcFrame& frame);

/// A stretch along which two segments lie on each other, by two of its places: from.a < to.a.
struct CommonPart {
    Contact from;
    Contact to;
};

struct SegmentContacts {
    std::vector<Contact> contacts;
    std::vector<CommonPart> common;
};

/// How two different segments meet. At `joints`, where ends of both are joined, they do not, nor do they inside of or
/// at the ends of common parts.
///
/// Common parts end at ends of segments, so they are looked for first, between the places where an end lies on the
/// other segment. The rest is for ContactSearch.
[[nodiscard]] SegmentContacts contactsOf(const CuspedArc& a, const CuspedArc& b, std::span<const Contact> joints,
                                         const ContactScale& scale, WorkBudget& budget);

} // namespace kriva
