#include "ui/figures/caption_text.h"

#include "ui/base/language/number_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

class Captions {
    Q_DECLARE_TR_FUNCTIONS(Caption)
  public:
    // A table, but as a switch without a default: the compiler names a caption that has no words yet.
    // NOLINTNEXTLINE(readability-function-size)
    static QString text(Caption caption) {
        switch (caption) {
        case Caption::none:
            return {};
        case Caption::elevation:
            return tr("Degree elevation");
        case Caption::subdivision:
            return tr("Subdivision");
        case Caption::spline:
            return tr("Spline");
        case Caption::combined:
            return tr("Combined algorithm");
        case Caption::curve:
            return tr("Curve");
        case Caption::controlPolygon:
            return tr("Control polygon");
        case Caption::elevatedPolygon:
            return tr("Elevated polygon");
        case Caption::points:
            return tr("Points");
        case Caption::labels:
            return tr("Labels");
        case Caption::construction:
            return tr("De Casteljau scheme");
        case Caption::partialCurves:
            return tr("Curves of degree n − 1");
        case Caption::pieces:
            return tr("Pieces");
        case Caption::leftPolygon:
            return tr("Left polygon");
        case Caption::rightPolygon:
            return tr("Right polygon");
        case Caption::curvePoint:
            return tr("Point of the curve");
        case Caption::blossom:
            return tr("Blossom");
        case Caption::partLabels:
            return tr("Labels of left and right");
        case Caption::degree:
            return tr("Degree");
        case Caption::length:
            return tr("Length");
        case Caption::bounds:
            return tr("Bounds");
        case Caption::elevatedDegree:
            return tr("Degree after elevation");
        case Caption::gap:
            return tr("Gap between polygon and curve");
        case Caption::pointAtT:
            return tr("Point at t");
        case Caption::derivativeAtT:
            return tr("Derivative at t");
        case Caption::pieceCount:
            return tr("Number of pieces");
        case Caption::knots:
            return tr("Knots");
        case Caption::handles:
            return tr("Handles");
        case Caption::endDerivatives:
            return tr("End derivatives");
        case Caption::segmentLength:
            return tr("Length of segment");
        case Caption::coefficients:
            return tr("Coefficients of segment");
        case Caption::continuity:
            return tr("Continuity at knot");
        case Caption::openEnd:
            return tr("open end");
        case Caption::curvatureExtrema:
            return tr("Extrema of the curvature");
        case Caption::crossings:
            return tr("Crossings");
        case Caption::crossingCount:
            return tr("Crossings of the sheet");
        case Caption::crossing:
            return tr("Crossing");
        case Caption::passCount:
            return tr("Passes through crossings and overlaps");
        case Caption::tooManyToCount:
            return tr("too many to count");
        case Caption::overlapCount:
            return tr("Overlaps of the sheet");
        case Caption::bendingEnergy:
            return tr("Bending energy");
        case Caption::givenPolygon:
            return tr("Polygon of the given points");
        case Caption::runs:
            return tr("Monotone runs");
        case Caption::joins:
            return tr("Joins");
        case Caption::middlePoints:
            return tr("Middle points of pairs");
        case Caption::runNumbers:
            return tr("Numbers of runs");
        case Caption::allPolygons:
            return tr("All polygons so far");
        case Caption::convexHull:
            return tr("Convex hull");
        case Caption::endTangents:
            return tr("End tangents");
        case Caption::furtherConstructions:
            return tr("De Casteljau schemes at further t");
        case Caption::curvatureComb:
            return tr("Curvature comb");
        case Caption::inflections:
            return tr("Inflections");
        case Caption::continuityBadges:
            return tr("Continuity at the knots");
        case Caption::allRules:
            return tr("All rules");
        case Caption::deCasteljauPolyline:
            return tr("De Casteljau polyline");
        case Caption::runPolygons:
            return tr("Polygons of runs");
        case Caption::polynomials:
            return tr("Polynomials of runs");
        case Caption::mirror:
            return tr("mirror");
        case Caption::natural:
            return tr("natural");
        case Caption::clamped:
            return tr("clamped");
        case Caption::catmullRom:
            return tr("Catmull–Rom");
        case Caption::runPoints:
            return tr("Points of run");
        case Caption::runDegree:
            return tr("Degree of run");
        case Caption::runCoefficients:
            return tr("Coefficients of run");
        case Caption::residual:
            return tr("Residual (root mean square)");
        case Caption::rms:
            return tr("Residual (root mean square) of run");
        case Caption::maxError:
            return tr("Largest residual of run");
        case Caption::largestKink:
            return tr("Largest kink");
        case Caption::slopeVariation:
            return tr("Slope variation");
        case Caption::incomplete:
            return tr("This curve needs more points");
        case Caption::bernsteinPolynomials:
            return tr("Bernstein polynomials");
        case Caption::controlPoint:
            return tr("Control point");
        case Caption::weight:
            return tr("Weight");
        case Caption::weightsAtT:
            return tr("Weights at t");
        case Caption::level:
            return tr("Level");
        case Caption::leftAndRight:
            return tr("Left and right polygon");
        case Caption::newPoints:
            return tr("Points of the last elevation");
        case Caption::hodograph:
            return tr("Hodograph");
        case Caption::segment:
            return tr("Segment");
        case Caption::rule:
            return tr("Rule");
        case Caption::largestCurvature:
            return tr("Largest curvature");
        case Caption::run:
            return tr("Run");
        case Caption::afterRun:
            return tr("After run");
        case Caption::valuesOfRuns:
            return tr("Values of the runs, y(x)");
        case Caption::slopesOfRuns:
            return tr("Slopes of the runs, y′(x)");
        case Caption::method:
            return tr("Method");
        case Caption::methods:
            return tr("Comparison of methods");
        case Caption::interpolation:
            return tr("Interpolation");
        case Caption::approximation:
            return tr("Approximation");
        case Caption::pairs:
            return tr("Pairs");
        case Caption::grid:
            return tr("Grid");
        case Caption::axisNumbers:
            return tr("Numbers of the axes");
        case Caption::axes:
            return tr("Axes");
        case Caption::lines:
            return tr("Lines");
        case Caption::placeOnView:
            return tr("Place on view");
        case Caption::legend:
            return tr("Legend");
        }
        return {};
    }
};

} // namespace

QString captionText(Caption caption) {
    return Captions::text(caption);
}

TextSource textSource() {
    return {[](Caption caption) { return captionText(caption).toStdString(); },
            [](double value, int decimals) { return withMinus(formatNumber(value, decimals)).toStdString(); },
            QLocale().bcp47Name().toStdString()};
}

} // namespace kriva::ui
