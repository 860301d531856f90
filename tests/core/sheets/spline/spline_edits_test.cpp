#include "core/geometry/box.h"
#include "core/io/json/document_json.h"
#include "core/sheets/spline/spline.h"
#include "tests/core/sheets/spline/spline_values.h"
#include "tests/support/sheet_curves.h"

namespace kriva {
namespace {

using test::anySpline;
using test::curveThrough;
using test::farthest;
using test::heldKnot;
using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

/// All counts of the value are valid: a document with it can be read again.
void assertReadable(const SplineCurve& curve) {
    Document document;
    document.sheets[*sheetNamed("spline")].curves = test::curves({curve});
    const auto read = readDocument(writeDocument(document));
    RC_ASSERT(std::holds_alternative<Document>(read));
    RC_ASSERT(std::get<Document>(read) == document);
}

std::vector<int> anyIndices(std::size_t count) {
    std::vector<int> indices;
    for (int i = 0; i < static_cast<int>(count); ++i)
        if (*rc::gen::inRange(0, 4) == 0)
            indices.push_back(i);
    return indices;
}

Point gripAt(const SplineCurve& curve, const GripId& id) {
    for (const Grip& grip : grips(curve))
        if (grip.id == id)
            return grip.at;
    ADD_FAILURE() << "no such grip";
    return {};
}

RC_GTEST_PROP(SplineGrips, eachMovesByWhatItIsDragged, ()) {
    const SplineCurve curve = anySpline();
    const Grip grip = *rc::gen::elementOf(grips(curve));
    const Vector by = *test::anyPoint() - Point{};
    const SplineCurve moved = withGripsMoved(curve, std::vector{grip.id}, by);
    RC_ASSERT(distance(gripAt(moved, grip.id), grip.at + by) <= 1e-9);
    assertReadable(moved);
}

RC_GTEST_PROP(SplineGrips, allKnotsTogetherMoveTheWholeCurve, ()) {
    const SplineCurve curve = anySpline();
    const Vector by = *test::anyPoint() - Point{};
    std::vector<GripId> ids;
    for (const Grip& grip : grips(curve)) // handles and inner points too: they move once, with their knots
        ids.push_back(grip.id);
    std::vector<Points> moved = solveSpline(withGripsMoved(curve, ids, by)).segments;
    for (Points& segment : moved)
        for (Point& p : segment)
            p = p - by;
    RC_ASSERT(farthest(moved, solveSpline(curve).segments) <= 1e-9);
}

TEST(SplineGrips, comeKnotsFirst) {
    SplineCurve curve = curveThrough(Rule::clamped, {{0, 0}, {3, 3}}, false, 4);
    curve.startDerivative = Vector{3, 0};
    std::vector<GripKind> kinds;
    for (const Grip& grip : grips(curve))
        kinds.push_back(grip.id.kind);
    EXPECT_EQ(kinds, (std::vector{GripKind::point, GripKind::point, GripKind::outHandle, GripKind::inHandle,
                                  GripKind::inner, GripKind::startDerivative, GripKind::endDerivative}));
    EXPECT_EQ(gripAt(curve, {GripKind::startDerivative}), (Point{3, 0}));
    EXPECT_EQ(gripAt(curve, {GripKind::outHandle, 0}), (Point{1, 0}));
}

TEST(SplineGrips, thatDoNotExistArePassedOver) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}});
    const std::vector<GripId> ids = {{GripKind::point, 2},        {GripKind::inHandle, 0}, {GripKind::inner, 0},
                                     {GripKind::startDerivative}, {GripKind::middle, 0},   {GripKind::outHandle, 7}};
    EXPECT_EQ(withGripsMoved(curve, ids, {1, 1}), curve);
}

TEST(SplineGrips, storedHandlesGoWithTheirKnot) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}});
    curve.knots[1] = heldKnot({3, 3}, Join::corner, Point{2, 3}, Point{3, 5});
    const SplineCurve moved = withGripsMoved(curve, std::vector<GripId>{{GripKind::point, 1}}, {1, -1});
    EXPECT_EQ(moved.knots[1], heldKnot({4, 2}, Join::corner, Point{3, 2}, Point{4, 4}));
}

TEST(SplineGrips, innerPointsStayUnlessBothTheirKnotsGo) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}, false, 4);
    curve.inner[0] = {{1, 1}};
    const std::vector<GripId> one = {{GripKind::point, 0}};
    const std::vector<GripId> both = {{GripKind::point, 0}, {GripKind::point, 1}};
    EXPECT_EQ(withGripsMoved(curve, one, {5, 5}).inner, curve.inner);
    EXPECT_EQ(withGripsMoved(curve, both, {5, 5}).inner, (std::map<int, Points>{{0, {{6, 6}}}}));
}

TEST(SplineGrips, aMovedInnerPointStoresTheOtherToo) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {5, 5}}, false, 5);
    const SplineCurve moved = withGripsMoved(curve, std::vector<GripId>{{GripKind::inner, 0, 1}}, {0, 1});
    ASSERT_EQ(moved.inner.at(0).size(), 2u);
    EXPECT_NEAR(distance(moved.inner.at(0)[0], {2, 2}), 0, 1e-14);
    EXPECT_NEAR(distance(moved.inner.at(0)[1], {3, 4}), 0, 1e-14);
}

RC_GTEST_PROP(SplinePointAdded, standsAtTheEnd, ()) {
    const SplineCurve curve = anySpline();
    const Point at = *test::anyPoint();
    const Edited<SplineCurve> edited = withPointAdded(curve, at);
    RC_ASSERT(edited.curve.knots.back() == heldKnot(at, Join::automatic, {}, {}));
    RC_ASSERT(edited.curve.knots.size() == curve.knots.size() + 1);
    RC_ASSERT(edited.map(0) == 0);
    assertReadable(edited.curve);
}

TEST(SplinePointAdded, takesTheClosingSegmentApart) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}}, true, 4);
    curve.inner = {{1, {{1, 1}}}, {2, {{2, 2}}}};
    EXPECT_EQ(withPointAdded(curve, {3, -3}).curve.inner, (std::map<int, Points>{{1, {{1, 1}}}}));
}

TEST(SplinePointAdded, completesTheHandleOfAKnotThatWasTheLast) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}});
    curve.knots[1] = heldKnot({3, 3}, Join::symmetric, Point{2, 3}, {});
    EXPECT_EQ(withPointAdded(curve, {6, 0}).curve.knots[1].out, (Point{4, 3}));
}

RC_GTEST_PROP(SplineAppended, keepsTheKnotsOfBoth, ()) {
    const SplineCurve curve = anySpline();
    const SplineCurve other = anySpline();
    const SplineCurve both = appended(curve, other);
    RC_ASSERT(both.knots.size() == curve.knots.size() + other.knots.size());
    for (std::size_t i = 0; i < other.knots.size(); ++i) {
        RC_ASSERT(both.knots[curve.knots.size() + i].at == other.knots[i].at);
        RC_ASSERT(both.knots[curve.knots.size() + i].join == other.knots[i].join);
    }
    assertReadable(both);
}

TEST(SplineAppended, bringsTheInnerPointsOfItsSegments) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}}, false, 4);
    SplineCurve other = curveThrough(Rule::mirror, {{6, 0}, {9, 3}, {12, 0}}, true, 4);
    other.inner = {{1, {{1, 1}}}, {2, {{2, 2}}}}; // the last one closes it
    EXPECT_EQ(appended(curve, other).inner, (std::map<int, Points>{{3, {{1, 1}}}}));
    curve.degree = 5;
    EXPECT_TRUE(appended(curve, other).inner.empty());
}

RC_GTEST_PROP(SplinePointsRemoved, leaveTheOthersAsTheyAre, ()) {
    const SplineCurve curve = anySpline();
    const std::vector<int> gone = anyIndices(curve.knots.size());
    const Edited<SplineCurve> edited = withPointsRemoved(curve, gone);
    RC_ASSERT(edited.curve.knots.size() == curve.knots.size() - gone.size());
    for (int old = 0; old < static_cast<int>(curve.knots.size()); ++old)
        if (const int now = edited.map(old); now != IndexMap::kGone)
            RC_ASSERT(edited.curve.knots[static_cast<std::size_t>(now)] == curve.knots[static_cast<std::size_t>(old)]);
    assertReadable(edited.curve);
}

TEST(SplinePointsRemoved, innerPointsOfTouchedSegmentsDropAndOthersShift) {
    SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}, {9, 3}, {12, 0}}, true, 4);
    curve.inner = {{0, {{0, 0}}}, {1, {{1, 1}}}, {2, {{2, 2}}}, {3, {{3, 3}}}, {4, {{4, 4}}}};
    EXPECT_EQ(withPointsRemoved(curve, {1}).curve.inner,
              (std::map<int, Points>{{1, {{2, 2}}}, {2, {{3, 3}}}, {3, {{4, 4}}}}));
}

RC_GTEST_PROP(SplineReversed, runsThroughTheSameCurveBackwards, ()) {
    const SplineCurve curve = anySpline();
    const Edited<SplineCurve> edited = reversed(curve);
    std::vector<Points> backwards = solveSpline(edited.curve).segments;
    std::ranges::reverse(backwards);
    for (Points& segment : backwards)
        std::ranges::reverse(segment);
    const bool isOpenOrCubic = !curve.closed || curve.degree > 2;
    // A closed chain of parabolas is closed at its first knot, which stays the first.
    RC_ASSERT(farthest(backwards, solveSpline(curve).segments) <= (isOpenOrCubic ? 1e-9 : 1e-8));
    for (int old = 0; old < static_cast<int>(curve.knots.size()); ++old)
        RC_ASSERT(edited.curve.knots[static_cast<std::size_t>(edited.map(old))].at ==
                  curve.knots[static_cast<std::size_t>(old)].at);
    assertReadable(edited.curve);
}

TEST(SplineReversed, swapsAndNegatesTheEndDerivatives) {
    SplineCurve curve = curveThrough(Rule::clamped, {{0, 0}, {3, 3}});
    curve.startDerivative = Vector{1, 2};
    const SplineCurve turned = reversed(curve).curve;
    EXPECT_FALSE(turned.startDerivative);
    EXPECT_EQ(turned.endDerivative, (Vector{-1, -2}));
}

TEST(SplineReversed, storesWhatTheMirrorRulePlaced) {
    const SplineCurve curve = curveThrough(Rule::mirror, {{0, 0}, {3, 3}, {6, 0}});
    for (const SplineKnot& knot : reversed(curve).curve.knots)
        EXPECT_EQ(knot.join, Join::symmetric);
    const SplineCurve natural = curveThrough(Rule::natural, {{0, 0}, {3, 3}, {6, 0}});
    EXPECT_TRUE(isAutomatic(reversed(natural).curve.knots[1]));
}

} // namespace
} // namespace kriva
