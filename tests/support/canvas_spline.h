#pragma once

#include "ui/canvas/canvas_curves.h"

namespace kriva::test {

/// What a spline tab shows: the curve of cubics, its knots' polygon, marks, and a grip for each knot.
[[nodiscard]] inline ui::CanvasCurve splineOf(const Points& knots, ui::Serial serial = 1) {
    Path path{{knots.front()}, {}, false};
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const Vector way = knots[i] - knots[i - 1];
        const Vector across{-way.y / 4, way.x / 4};
        path.points.insert(path.points.end(), {knots[i - 1] + way / 3 + across, knots[i] - way / 3 - across, knots[i]});
        path.degrees.push_back(3);
    }
    ui::CanvasCurve curve;
    curve.serial = serial;
    curve.isActive = true;
    curve.figure.layers = {{"control-polygon", {{.path = polyline(knots), .role = Role::controlPolygon}}},
                           {"curve", {{.path = path}}},
                           {"knots", {}, {{knots, Role::knot}}}};
    for (const Point knot : knots)
        curve.grips.push_back({{GripKind::point, static_cast<int>(curve.grips.size()), 0}, knot});
    return curve;
}

} // namespace kriva::test
