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
    construction,
    partialCurves,
    pieces,
    leftPolygon,
    rightPolygon,
    curvePoint,
    blossom,
    partLabels,
    knots,
    handles,
    endDerivatives,
    givenPolygon,
    runs,
    joins,
    middlePoints,
    crossings,
    runNumbers,
    allPolygons,
    convexHull,
    endTangents,
    furtherConstructions,
    curvatureComb,
    inflections,
    continuityBadges,
    allRules,
    deCasteljauPolyline,
    runPolygons,
    polynomials,
    // rules of splines, on figures
    mirror,
    natural,
    clamped,
    catmullRom,
    // results
    degree,
    length,
    bounds,
    elevatedDegree,
    gap,
    pointAtT,
    derivativeAtT,
    pieceCount,
    segmentLength, ///< by segment
    coefficients,  ///< by segment, of the powers of t
    continuity,    ///< by knot
    openEnd,       ///< of a chain: the continuity of its first and last knot
    crossingCount, ///< of the sheet
    crossing,      ///< by number
    passCount,     ///< of the sheet, through crossings and overlaps
    tooManyToCount,
    overlapCount,
    curvatureExtrema,
    bendingEnergy,
    runPoints, ///< by run, first and last
    runDegree,
    runCoefficients,
    rms,      ///< by run
    residual, ///< the same in a table that says of what
    maxError,
    largestKink,
    slopeVariation,
    incomplete,
    // plots and tables
    bernsteinPolynomials,
    controlPoint,
    weight,
    weightsAtT,
    level,        ///< by number
    leftAndRight, ///< the polygons of the two parts
    newPoints,    ///< of the last elevation
    hodograph,
    segment,
    rule,
    largestCurvature,
    run, ///< by number
    afterRun,
    valuesOfRuns,
    slopesOfRuns,
    method,
    methods,
    interpolation,
    approximation,
    pairs,
    // layers of plots
    grid,
    axisNumbers,
    axes,
    lines,
    placeOnView,
    legend,
};

} // namespace kriva
