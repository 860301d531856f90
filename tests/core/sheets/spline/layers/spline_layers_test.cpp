#include "core/sheets/spline/layers/spline_layers.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

using test::curveThrough;
using Rule = SplineCurve::Rule;

Points inflectionsOf(const SplineCurve& curve) {
    return inflectionsLayer(curve, solveSpline(curve), shapesOf(curve)).marks.at(0).at;
}

RC_GTEST_PROP(ContinuityLayer, saysOfEveryInnerKnotWhatTheReportSays, ()) {
    const SplineCurve curve = test::anySpline();
    const SplineChain chain = solveSpline(curve);
    const Layer layer = continuityLayer(curve, chain);
    auto label = layer.labels.begin();
    for (std::size_t i = 0; i < chain.continuity.size(); ++i) {
        if (chain.continuity[i] == Continuity::end)
            continue;
        RC_ASSERT(label != layer.labels.end());
        RC_ASSERT(label->text == nameOf(chain.continuity[i]));
        RC_ASSERT(label->at == curve.knots[i].at);
        ++label;
    }
    RC_ASSERT(label == layer.labels.end());
}

TEST(InflectionsLayer, marksWhereABendChangesSides) {
    const Points s = inflectionsOf(curveThrough(Rule::natural, {{0, 0}, {1, 1}, {3, -1}, {4, 0}}));
    ASSERT_EQ(s.size(), 1u);
    EXPECT_NEAR(s[0].x, 2, 1e-9);
    EXPECT_NEAR(s[0].y, 0, 1e-9);
    EXPECT_TRUE(inflectionsOf(curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}})).empty());
    EXPECT_TRUE(inflectionsOf(curveThrough(Rule::mirror, {{0, 0}, {1, 1}, {3, 3}})).empty());
}

TEST(InflectionsLayer, marksAKnotInWhichABendChangesSides) {
    // Point symmetric about the middle knot, where the curvature vanishes.
    const SplineCurve curve = curveThrough(Rule::natural, {{-3, 0}, {-2, 2}, {0, 0}, {2, -2}, {3, 0}});
    const Points places = inflectionsOf(curve);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].x, 0, 1e-9);
    EXPECT_NEAR(places[0].y, 0, 1e-9);
}

TEST(InflectionsLayer, doesNotTakeACornerForOne) {
    SplineCurve curve = curveThrough(Rule::natural, {{0, 0}, {2, 0}, {4, 0}});
    curve.knots[0] = test::heldKnot({0, 0}, SplineKnot::Join::corner, {}, Point{0, 2});
    curve.knots[1] = test::heldKnot({2, 0}, SplineKnot::Join::corner, Point{2, 2}, Point{2, -2});
    curve.knots[2] = test::heldKnot({4, 0}, SplineKnot::Join::corner, Point{4, -2}, {});
    EXPECT_EQ(inflectionsOf(curve), (Points{{2, 0}})); // straight on, and bent to the other side
    curve.knots[1].out = Point{3, -2};
    EXPECT_EQ(inflectionsOf(curve), Points{});
}

RC_GTEST_PROP(AllRulesLayer, drawsTheChainOfEveryRuleThroughTheSameKnots, ()) {
    const SplineCurve curve = test::anySpline();
    const Layer layer = allRulesLayer(curve);
    if (curve.degree == 2) {
        RC_ASSERT(layer.strokes.empty());
        return;
    }
    RC_ASSERT(layer.strokes.size() == 4u);
    RC_ASSERT(layer.labels.size() == 4u);
    for (int i = 0; i < 4; ++i) {
        SplineCurve ruled = curve;
        ruled.rule = static_cast<Rule>(i);
        const Stroke& stroke = layer.strokes[static_cast<std::size_t>(i)];
        RC_ASSERT(stroke.path == chain(segmentsOf(ruled), curve.closed));
        RC_ASSERT(stroke.series == i);
    }
}

TEST(PolylineLayer, runsThroughPointsOfEverySegmentAtEqualSteps) {
    const std::vector<Points> segments{{{0, 0}, {0, 2}, {8, 2}, {4, 0}}, {{4, 0}, {6, -4}, {8, 0}}};
    EXPECT_EQ(deCasteljauPolyline(segments, 2), (Points{{0, 0}, {4, 0}, {8, 0}}));
    EXPECT_EQ(deCasteljauPolyline(segments, 3), (Points{{0, 0}, {3.5, 1.5}, {4, 0}, {6, -2}, {8, 0}}));
    const Layer layer = polylineLayer(segments, 3);
    EXPECT_EQ(layer.strokes.at(0).path, polyline(deCasteljauPolyline(segments, 3)));
    EXPECT_EQ(layer.marks.at(0).at, deCasteljauPolyline(segments, 3));
}

} // namespace
} // namespace kriva
