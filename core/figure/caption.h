#pragma once

namespace kriva {

/// The words that core puts on figures and beside numbers. Core holds no sentence: their texts are made in ui.
enum class Caption {
    none,
    // sheets
    elevation,
    subdivision,
    spline,
    combined,
    // layers
    curve,
    controlPolygon,
    elevatedPolygon,
    points,
    labels,
    // results
    degree,
    length,
    bounds,
    elevatedDegree,
    gap,
    incomplete,
};

} // namespace kriva
