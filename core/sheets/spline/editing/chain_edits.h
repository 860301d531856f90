#pragma once

#include "core/curve/editing/edited.h"
#include "core/sheets/spline/chain/spline_curve.h"

/// The edits of a whole chain that only splines have. See joins.h for those of single knots.
namespace kriva {

/// One more knot on a segment, 0 < t < 1, without a change of shape: de Casteljau's split. The segment's own ends
/// become smooth with stored handles unless they are corners. With parabolas the shape changes: the new knot lies on
/// the old curve, and all middle points are found anew.
[[nodiscard]] Edited<SplineCurve> withKnotInserted(const SplineCurve& curve, int segment, double t);

/// From 2 to 5. From 4 to 5 inner points are raised with their segment, from 5 to 4 they drop; 2 and 3 keep them.
[[nodiscard]] SplineCurve withDegree(const SplineCurve& curve, int degree);
[[nodiscard]] SplineCurve withRule(SplineCurve curve, SplineCurve::Rule rule);
[[nodiscard]] SplineCurve withClosed(SplineCurve curve, bool closed);
/// Nothing means the natural chain's.
[[nodiscard]] SplineCurve withEndDerivatives(SplineCurve curve, std::optional<Vector> start, std::optional<Vector> end);

/// The curve pulled by one of its points: the segment's point at t, 0 < t < 1, moves by the vector, through the least
/// change of the segment's two handles (in the sum of squares); they keep the promises of their joins, and automatic
/// knots become symmetric. A chain of parabolas stays as it is.
[[nodiscard]] SplineCurve withSegmentPulled(const SplineCurve& curve, int segment, double t, Vector by);

} // namespace kriva
