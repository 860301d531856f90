#pragma once

#include "core/geometry/point.h"

#include <array>
#include <compare>

namespace kriva {

/// Everything of a curve that can be taken hold of and dragged.
enum class GripKind {
    point,           ///< a control, given or knot point: the points of the Points table
    inHandle,        ///< of the knot `index`
    outHandle,       ///< of the knot `index`
    inner,           ///< free control point `part` of the segment `index`
    middle,          ///< middle point of the pair that starts at the point `index`
    startDerivative, ///< tip of the arrow
    endDerivative,   ///< tip of the arrow
};

inline constexpr std::array kGripKinds{GripKind::point,        GripKind::inHandle, GripKind::outHandle,
                                       GripKind::inner,        GripKind::middle,   GripKind::startDerivative,
                                       GripKind::endDerivative};

struct GripId {
    GripKind kind = GripKind::point;
    int index = 0;
    int part = 0;
    friend constexpr auto operator<=>(const GripId&, const GripId&) = default;
};

struct Grip {
    GripId id;
    Point at;
    friend constexpr bool operator==(const Grip&, const Grip&) = default;
};

/// The grips of the points themselves, in their order.
[[nodiscard]] std::vector<Grip> pointGrips(std::span<const Point> points);

/// The points, those whose grips are named moved; other kinds and grips that do not exist are passed over.
[[nodiscard]] Points withPointsMoved(const Points& points, std::span<const GripId> ids, Vector by);

} // namespace kriva
