#pragma once

#include "core/document/edited.h"
#include "core/spline/spline.h"

namespace kriva {

struct RefittedRemoval {
    Edited<SplineCurve> edited;
    /// How far what goes lies from the new segments, at most, measured at places spread over it, in document units;
    /// nothing where nothing was fitted: at open ends, for parabolas, where too few knots are left.
    std::optional<double> deviation;
};

/// Removes knots (indices ascending) so that the shape changes least: the neighbours keep their tangents, and the
/// lengths of their handles towards each other are fitted to what goes, by least squares of the distances. They become
/// smooth with stored handles unless they are corners, so that the rest of the curve stays where it is. Parabolas have
/// no handles and are solved anew. Linear in the knots.
/// Source: orthogonal distance fitting by Gauss and Newton's method; Ahn, Least Squares Orthogonal Distance Fitting of
/// Curves and Surfaces in Space (2004), chapter 2.
[[nodiscard]] RefittedRemoval withPointsRemovedRefitted(const SplineCurve& curve, const std::vector<int>& indices);

} // namespace kriva
