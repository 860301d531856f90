#pragma once

#include "core/curve/editing/grip.h"
#include "core/curve/editing/handle_way.h"
#include "core/sheets/spline/chain/spline.h"

/// What a hand does to one handle, or to the arrow of an end derivative.
namespace kriva {

/// One handle or arrow dragged. An automatic knot becomes symmetric, and a corner where the other handle is left
/// behind; else the join keeps its promise. Where an angle is held, the handle comes as near to the pointer as its ray
/// allows, at worst onto the knot. A grip that does not exist, or no handle, changes nothing but what is carried. O(n).
[[nodiscard]] SplineCurve withHandleDragged(const SplineCurve& curve, const GripId& id, const HandleWay& way);

/// The handle on its knot, which becomes a corner, so that the other handle stays; the arrow of an end derivative gives
/// way to the natural chain's. Nothing for other grips.
[[nodiscard]] std::optional<SplineCurve> withHandleRetracted(const SplineCurve& curve, const GripId& id);

/// Whether its knots have handles: parabolas have none.
[[nodiscard]] inline bool pullsHandles(const SplineCurve& curve) {
    return curve.degree > 2;
}

/// The curve with a symmetric knot whose handles are retracted, about to be pulled by its out handle; nothing where
/// parabolas have none.
[[nodiscard]] std::optional<SplineCurve> readyToPull(SplineCurve curve, int knot);

/// The open chain closed by a click on one of its points: on the first knot of at least three, else nothing.
[[nodiscard]] std::optional<SplineCurve> closedAt(const SplineCurve& curve, int knot);

} // namespace kriva
