#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

constexpr double kClose = 1e-12 * 1000;

rc::Gen<double> anyInnerParameter() {
    return rc::gen::map(rc::gen::inRange(1, 1000), [](int i) { return i / 1000.0; });
}

TEST(DeCasteljau, showsTheTextbookTriangle) {
    const Points curve{{0, 0}, {0, 2}, {8, 2}, {4, 0}};
    const Triangle expected{curve, {{0, 1}, {4, 2}, {6, 1}}, {{2, 1.5}, {5, 1.5}}, {{3.5, 1.5}}};
    EXPECT_EQ(deCasteljau(curve, 0.5), expected);
}

TEST(Subdivide, aSinglePointIsAllItsParts) {
    const Points point{{3, 4}};
    EXPECT_EQ(deCasteljau(point, 0.3), Triangle{point});
    EXPECT_EQ(split(point, 0.3).left, point);
    EXPECT_EQ(split(point, 0.3).right, point);
    EXPECT_EQ(part(point, 0.1, 0.2), point);
    EXPECT_EQ(pieces(point, 0.3, 2), std::vector<Points>(4, point));
    EXPECT_EQ(blossom(point, {}), point[0]);
}

RC_GTEST_PROP(DeCasteljau, endsInThePointOfTheCurve, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const double t = *anyInnerParameter();
    const Triangle triangle = deCasteljau(curve, t);
    RC_ASSERT(triangle.size() == curve.size());
    RC_ASSERT(triangle.front() == curve);
    RC_ASSERT(triangle.back() == Points{evaluate(curve, t)});
}

RC_GTEST_PROP(DeCasteljau, endsInTheBlossomOfItsParameters, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const auto parameters = *rc::gen::container<std::vector<double>>(curve.size() - 1, test::anyParameter());
    const Triangle triangle = deCasteljau(curve, parameters);
    RC_ASSERT(triangle.size() == curve.size());
    RC_ASSERT(triangle.back() == Points{blossom(curve, parameters)});
}

RC_GTEST_PROP(Split, halvesRejoinExactly, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const Halves halves = split(curve, *anyInnerParameter());
    RC_ASSERT(halves.left.front() == curve.front());
    RC_ASSERT(halves.left.back() == halves.right.front());
    RC_ASSERT(halves.right.back() == curve.back());
}

RC_GTEST_PROP(Split, halvesFollowTheCurve, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const double t = *anyInnerParameter();
    const double u = *test::anyParameter();
    const Halves halves = split(curve, t);
    RC_ASSERT(distance(evaluate(halves.left, u), evaluate(curve, t * u)) <= kClose);
    RC_ASSERT(distance(evaluate(halves.right, u), evaluate(curve, t + (1 - t) * u)) <= kClose);
}

RC_GTEST_PROP(Split, intoArraysGivesTheSameHalvesInPlaceToo, ()) {
    Points curve = *test::anyCurve(0, 20);
    const double t = *anyInnerParameter();
    const Halves halves = split(curve, t);
    Points left(curve.size()), right(curve.size());
    split(curve, t, left, right);
    RC_ASSERT(left == halves.left);
    RC_ASSERT(right == halves.right);
    split(left, t, left, right);
    RC_ASSERT(left == split(halves.left, t).left);
    split(curve, t, left, curve);
    RC_ASSERT(curve == halves.right);
}

RC_GTEST_PROP(Part, intoAnArrayGivesTheSameInPlaceToo, ()) {
    Points curve = *test::anyCurve(0, 20);
    const auto [from, to] = std::minmax({*test::anyParameter(), *test::anyParameter()});
    const Points expected = part(curve, from, to);
    part(curve, from, to, curve);
    RC_ASSERT(curve == expected);
}

RC_GTEST_PROP(Part, followsTheCurve, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const auto [from, to] = std::minmax({*test::anyParameter(), *test::anyParameter()});
    const double u = *test::anyParameter();
    const Points piece = part(curve, from, to);
    RC_ASSERT(distance(evaluate(piece, u), evaluate(curve, from + (to - from) * u)) <= kClose);
}

TEST(Part, ofTheWholeChangesNoBit) {
    const Points curve{{0.1, 0.2}, {1e9, 3}, {0.3, 0.7}};
    EXPECT_EQ(part(curve, 0, 1), curve);
}

TEST(Part, ofNoWidthIsOnePoint) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_EQ(part(curve, 0, 0), Points(4, curve.front()));
    EXPECT_EQ(part(curve, 1, 1), Points(4, curve.back()));
    EXPECT_EQ(part(curve, 0.5, 0.5), Points(4, Point{2, 1.5}));
}

RC_GTEST_PROP(Pieces, rejoinExactlyInCurveOrder, ()) {
    const Points curve = *test::anyCurve(0, 12);
    const std::vector<Points> chain = pieces(curve, *anyInnerParameter(), 4);
    RC_ASSERT(chain.size() == 16U);
    RC_ASSERT(chain.front().front() == curve.front());
    RC_ASSERT(chain.back().back() == curve.back());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        RC_ASSERT(chain[i].back() == chain[i + 1].front());
}

/// The pieces by splitting one after the other, as vectors from the start.
void addPieces(std::vector<Vector> row, double t, int levels, std::vector<std::vector<Vector>>& pieces) {
    if (levels == 0) {
        pieces.push_back(row);
        return;
    }
    std::vector<Vector> left;
    for (std::size_t count = row.size(); count > 0; --count) {
        left.push_back(row[0]);
        for (std::size_t i = 0; i + 1 < count; ++i)
            row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
    addPieces(left, t, levels - 1, pieces);
    addPieces(row, t, levels - 1, pieces);
}

RC_GTEST_PROP(Pieces, areTheSplitOnesToTheLastBit, ()) {
    const Points curve = *test::anyCurve(0, 20);
    const double t = *anyInnerParameter();
    const int levels = *rc::gen::inRange(0, 6);
    std::vector<Vector> row;
    for (const Point p : curve)
        row.push_back(p - curve.front());
    std::vector<std::vector<Vector>> expected;
    addPieces(row, t, levels, expected);
    const std::vector<Points> found = pieces(curve, t, levels);
    Points chain(((curve.size() - 1) << levels) + 1);
    writePieces(curve, t, levels, chain);
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const bool isEnd = k + 1 == found.size() && i + 1 == curve.size();
            RC_ASSERT(found[k][i] == (isEnd ? curve.back() : curve.front() + expected[k][i]));
            RC_ASSERT(chain[k * (curve.size() - 1) + i] == found[k][i]);
        }
}

TEST(Pieces, zeroLevelsGiveTheCurve) {
    const Points curve{{0.1, 0.2}, {1e9, 3}, {0.3, 0.7}};
    EXPECT_EQ(pieces(curve, 0.3, 0), std::vector<Points>{curve});
}

TEST(Pieces, reachTheLimitOfSixteenLevels) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const std::vector<Points> chain = pieces(curve, 0.5, 16);
    ASSERT_EQ(chain.size(), 65536U);
    EXPECT_EQ(chain[32768].front(), (Point{2, 1.5}));
    EXPECT_LE(distance(chain[16384].front(), evaluate(curve, 0.25)), 1e-15);
}

RC_GTEST_PROP(Blossom, isTheCurveOnItsDiagonal, ()) {
    const Points curve = *test::anyCurve(0, 12);
    const double t = *anyInnerParameter();
    RC_ASSERT(blossom(curve, std::vector<double>(curve.size() - 1, t)) == evaluate(curve, t));
}

RC_GTEST_PROP(Blossom, isSymmetric, ()) {
    const Points curve = *test::anyCurve(2, 8);
    auto arguments = *rc::gen::container<std::vector<double>>(curve.size() - 1, test::anyParameter());
    const Point before = blossom(curve, arguments);
    std::ranges::rotate(arguments, arguments.begin() + 1);
    std::swap(arguments.front(), arguments.back());
    RC_ASSERT(distance(before, blossom(curve, arguments)) <= kClose);
}

RC_GTEST_PROP(Blossom, isAffineInEachArgument, ()) {
    const Points curve = *test::anyCurve(1, 8);
    auto arguments = *rc::gen::container<std::vector<double>>(curve.size() - 1, test::anyParameter());
    const std::size_t which = *rc::gen::inRange<std::size_t>(0, arguments.size());
    const double t = *test::anyParameter();
    const auto at = [&](double u) {
        arguments[which] = u;
        return blossom(curve, arguments);
    };
    RC_ASSERT(distance(lerp(at(0.25), at(0.75), t), at(0.25 + 0.5 * t)) <= kClose);
}

RC_GTEST_PROP(Blossom, givesTheControlPointsAtZerosAndOnes, ()) {
    const Points curve = *test::anyCurve(1, 8);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        std::vector<double> arguments(curve.size() - 1, 0.0);
        std::fill_n(arguments.begin(), i, 1.0);
        RC_ASSERT(distance(blossom(curve, arguments), curve[i]) <= kClose);
    }
}

} // namespace
} // namespace kriva
