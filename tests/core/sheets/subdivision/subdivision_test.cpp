#include "core/bezier/evaluate.h"
#include "core/geometry/box.h"
#include "core/sheets/subdivision/subdivision.h"
#include "tests/core/sheets/subdivision/any_subdivision.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

using test::anySubdivision;

// The example of the Bulgarian lecture that format.md corrects.
SubdivisionCurve lectureExample() {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    curve.multiplicity = {1, 1, 1, 1};
    return curve;
}

double sizeOf(const SubdivisionCurve& curve) {
    return diagonal(boxOf(curve.points)) + 1;
}

TEST(Subdivision, cutsTheLecturesExampleInTheMiddle) {
    const Subdivision cut = subdivide(lectureExample());
    const Triangle triangle{
        {{0, 0}, {0, 2}, {8, 2}, {4, 0}}, {{0, 1}, {4, 2}, {6, 1}}, {{2, 1.5}, {5, 1.5}}, {{3.5, 1.5}}};
    EXPECT_EQ(cut.triangle, triangle);
    EXPECT_EQ(cut.halves.left, (Points{{0, 0}, {0, 1}, {2, 1.5}, {3.5, 1.5}}));
    EXPECT_EQ(cut.halves.right, (Points{{3.5, 1.5}, {5, 1.5}, {6, 1}, {4, 0}}));
    EXPECT_EQ(cut.derivative, (Vector{9, 0}));
    EXPECT_FALSE(cut.blossom);
}

TEST(Subdivision, countsEveryPointAsOftenAsItStands) {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {2, 4}, {4, 0}};
    curve.multiplicity = {1, 3, 1};
    curve.blossom = {0, 0.25, 0.5, 1};
    EXPECT_EQ(controlPolygon(curve), (Points{{0, 0}, {2, 4}, {2, 4}, {2, 4}, {4, 0}}));
    EXPECT_EQ(subdivide(curve).blossom, (Point{2, 4})); // b[0, u, v, 1] lies on the middle points alone
}

TEST(Subdivision, withoutLevelsHasOnePiece) {
    SubdivisionCurve curve = lectureExample();
    curve.levels = 0;
    EXPECT_EQ(pieces(curve), (std::vector<Points>{curve.points}));
}

TEST(Subdivision, ofOnePointManyTimesIsThatPoint) {
    SubdivisionCurve curve;
    curve.points = {{3, -2}, {3, -2}};
    curve.multiplicity = {2, 3};
    curve.levels = 2;
    for (const Points& piece : pieces(curve))
        EXPECT_EQ(piece, Points(5, {3, -2}));
    EXPECT_EQ(subdivide(curve).derivative, Vector{});
}

RC_GTEST_PROP(Subdivision, halvesAreTheSidesOfTheTriangle, ()) {
    const SubdivisionCurve curve = *anySubdivision();
    const Subdivision cut = subdivide(curve);
    const std::size_t n = cut.polygon.size() - 1;
    RC_ASSERT(cut.triangle.size() == n + 1);
    const double small = 1e-13 * sizeOf(curve);
    for (std::size_t r = 0; r <= n; ++r) {
        RC_ASSERT(cut.triangle[r].size() == n + 1 - r);
        RC_ASSERT(distance(cut.halves.left[r], cut.triangle[r].front()) <= small);
        RC_ASSERT(distance(cut.halves.right[n - r], cut.triangle[r].back()) <= small);
    }
}

RC_GTEST_PROP(Subdivision, piecesFollowEachOtherAlongTheCurve, ()) {
    const SubdivisionCurve curve = *anySubdivision();
    const Points polygon = controlPolygon(curve);
    const std::vector<Points> all = pieces(curve);
    RC_ASSERT(all.size() == std::size_t{1} << curve.levels);
    RC_ASSERT(all.front().front() == polygon.front());
    RC_ASSERT(all.back().back() == polygon.back());
    for (std::size_t i = 0; i < all.size(); ++i) {
        RC_ASSERT(all[i].size() == polygon.size());
        if (i > 0) // the macro evaluates both sides of a ||
            RC_ASSERT(all[i].front() == all[i - 1].back());
    }
}

RC_GTEST_PROP(Subdivision, firstPieceIsTheCurveUpToTToTheLevels, ()) {
    const SubdivisionCurve curve = *anySubdivision();
    const Points first = pieces(curve).front();
    const double end = std::pow(curve.t, curve.levels);
    const double u = *test::anyParameter();
    RC_ASSERT(distance(evaluate(first, u), evaluate(controlPolygon(curve), u * end)) <= 1e-12 * sizeOf(curve));
}

RC_GTEST_PROP(Subdivision, blossomOfEqualArgumentsIsThePointAtT, ()) {
    SubdivisionCurve curve = *anySubdivision();
    curve.blossom.emplace(controlPointCount(curve) - 1, curve.t);
    const Subdivision cut = subdivide(curve);
    RC_ASSERT(distance(*cut.blossom, cut.triangle.back().front()) <= 1e-13 * sizeOf(curve));
}

RC_GTEST_PROP(Subdivision, blossomIsSymmetric, ()) {
    SubdivisionCurve curve = *anySubdivision(4);
    RC_PRE(curve.blossom.has_value());
    const Point before = *subdivide(curve).blossom;
    std::reverse(curve.blossom->begin(), curve.blossom->end());
    // Arguments from [-1, 2] blow points up by at most 3 at each of the levels.
    const double blown = std::pow(3, static_cast<double>(curve.blossom->size()));
    RC_ASSERT(distance(*subdivide(curve).blossom, before) <= 1e-13 * blown * sizeOf(curve));
}

} // namespace
} // namespace kriva
