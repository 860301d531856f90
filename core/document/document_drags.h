#pragma once

#include "core/curve/editing/handle_way.h"
#include "core/document/document.h"

/// What a hand does to points and handles beyond moving them, for those that do not care about the kind of curve. Kinds
/// without handles answer with nothing.
namespace kriva {

/// Whether a new point has handles to pull.
[[nodiscard]] bool hasHandles(const Curve& curve);

/// A new point, and what of it follows the pointer while the button stays down.
struct PulledPoint {
    Curve curve;
    GripId grip;
};
/// Its handles, retracted at first, which the out handle pulls; else the point itself.
[[nodiscard]] PulledPoint readyToPull(const Curve& curve, int point);

/// Whether the grip is dragged around a point: a handle or an arrow.
[[nodiscard]] bool isHandle(GripKind kind);
/// Where the other handle of the same point stands, seen from that.
[[nodiscard]] std::optional<Vector> oppositeHandle(const Curve& curve, const GripId& handle);
[[nodiscard]] Curve withHandleDragged(const Curve& curve, const GripId& id, const HandleWay& way);
[[nodiscard]] std::optional<Curve> withHandleRetracted(const Curve& curve, const GripId& id);

/// A point more behind another one, or anywhere, that keeps the shape; nothing where there is no room for one.
[[nodiscard]] std::optional<Edited<Curve>> withPointInsertedBehind(const Curve& curve, std::optional<int> point);
/// Of the points that an insertion brought, the nearest to a place.
[[nodiscard]] int newPointNear(const Edited<Curve>& inserted, Point near);

/// An open chain closed by a click on one of its points: its first one; nothing elsewhere.
[[nodiscard]] std::optional<Curve> closedAt(const Curve& curve, int point);

} // namespace kriva
