#pragma once

#include "core/intersections/contacts/segment_contacts.h"

namespace kriva {

/// The places where one segment meets itself, a < b; a cusp is none.
///
/// With t = m - h and s = m + h the quotient (B(s) - B(t)) / (s - t) is a polynomial in m and v = h^2, so that a loop
/// is a plain root of two polynomials however small it is, a cusp a root with v = 0, an isolated double point one with
/// v < 0. Linear for cubics; for degrees 4 and 5 the roots are isolated by halving the rectangle of m and v.
/// A segment of degree 4 that is a parabola traced forth and back lies on itself.
[[nodiscard]] SegmentContacts doublePoints(const Arc& arc, const ContactScale& scale, WorkBudget& budget);

} // namespace kriva
