#include "core/sheets/spline/chain/continuity.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

const Points kArriving = {{-3, -1}, {-2, 0}, {-1, 0}, {0, 0}};

TEST(Continuity, isC2WhereBothDerivativesAgree) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {1, 0}, {2, 0}, {3, 5}}), Continuity::c2);
}

TEST(Continuity, isC1WhereOnlyTheFirstAgrees) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {1, 0}, {2, 1}, {3, 5}}), Continuity::c1);
}

TEST(Continuity, isG1WhereOnlyTheDirectionsAgree) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {2, 0}, {2, 1}, {3, 5}}), Continuity::g1);
}

// Straight at the joint on both sides: both curvatures vanish, whatever the speeds.
TEST(Continuity, isG2WhereTheCurvaturesAgreeToo) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {2, 0}, {5, 0}, {3, 5}}), Continuity::g2);
}

TEST(Continuity, isG2RatherThanC1WhereTheCurveIsSmootherThanItsParameter) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {1, 0}, {7, 0}, {3, 5}}), Continuity::g2);
}

TEST(Continuity, isC0WhereTheCurveTurns) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {0, 1}, {2, 1}, {3, 5}}), Continuity::c0);
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {-1, 0}, {2, 1}, {3, 5}}), Continuity::c0);
}

TEST(Continuity, aRetractedHandleHasNoDirection) {
    EXPECT_EQ(continuityBetween(kArriving, Points{{0, 0}, {0, 0}, {2, 0}, {3, 5}}), Continuity::c0);
    EXPECT_EQ(continuityBetween(Points{{-3, 0}, {-1, 0}, {0, 0}, {0, 0}}, Points{{0, 0}, {0, 0}, {2, 5}, {3, 5}}),
              Continuity::c1);
}

TEST(Continuity, twoPointsAreC2) {
    EXPECT_EQ(continuityBetween(Points(4, {1, 1}), Points(4, {1, 1})), Continuity::c2);
}

TEST(Continuity, toleratesABillionthOfTheLongerPolygon) {
    const auto leaving = [](double off) { return Points{{0, 0}, {1, off}, {2, 2 * off}, {1000, 0}}; };
    // L is about 1000: C1 allows |3 off| up to 1e-6, far beyond what G1 allows the sine.
    EXPECT_EQ(continuityBetween(kArriving, leaving(3e-7)), Continuity::c2);
    EXPECT_EQ(continuityBetween(kArriving, leaving(4e-7)), Continuity::c0);
    EXPECT_EQ(continuityBetween(kArriving, leaving(0.9e-9)), Continuity::c2);
}

RC_GTEST_PROP(Continuity, dependsNeitherOnPlaceNorOnScaleNorOnDirection, ()) {
    Points arriving = *rc::gen::container<Points>(4, test::anyPoint());
    Points leaving = *rc::gen::container<Points>(4, test::anyPoint());
    leaving[0] = arriving[3];
    if (*rc::gen::arbitrary<bool>())
        leaving[1] = mirrored(arriving[2], arriving[3]);
    const Continuity expected = continuityBetween(arriving, leaving);
    for (Points* points : {&arriving, &leaving})
        for (Point& p : *points)
            p = {p.y * 1024, -p.x * 1024 + 7};
    RC_ASSERT(continuityBetween(arriving, leaving) == expected);
    std::ranges::reverse(arriving);
    std::ranges::reverse(leaving);
    RC_ASSERT(continuityBetween(leaving, arriving) == expected);
}

TEST(Continuity, hasTheNamesOfTheReport) {
    EXPECT_EQ(nameOf(Continuity::c2), "C2");
    EXPECT_EQ(nameOf(Continuity::g2), "G2");
    EXPECT_EQ(nameOf(Continuity::c1), "C1");
    EXPECT_EQ(nameOf(Continuity::g1), "G1");
    EXPECT_EQ(nameOf(Continuity::c0), "C0");
    EXPECT_EQ(nameOf(Continuity::end), "end");
}

} // namespace
} // namespace kriva
