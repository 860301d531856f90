#pragma once

#include "core/curve/editing/edited.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// Removes knots (indices ascending) so that the shape changes least: the neighbours keep their tangents, and the
/// lengths of their handles towards each other are fitted to what goes, by least squares of the distances. They become
/// smooth with stored handles unless they are corners, so that the rest of the curve stays where it is. Parabolas have
/// no handles and are solved anew; nothing is fitted at open ends and where too few knots are left. Linear in the
/// knots. Source: orthogonal distance fitting by Gauss and Newton's method; Ahn, Least Squares Orthogonal Distance
/// Fitting of Curves and Surfaces in Space (2004), chapter 2.
[[nodiscard]] Refitted<SplineCurve> withPointsRemovedRefitted(const SplineCurve& curve,
                                                              const std::vector<int>& indices);

} // namespace kriva
