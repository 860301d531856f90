#include "core/bezier/cubic_pieces.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

/// The largest distance at the same parameter, on samples; the pieces must be equally wide.
double sampledDistance(const Points& curve, const std::vector<Cubic>& cubics) {
    double largest = 0;
    for (std::size_t i = 0; i < cubics.size(); ++i)
        for (const double u : {0.0, 0.2, 0.5, 0.7, 1.0}) {
            const double t = (static_cast<double>(i) + u) / static_cast<double>(cubics.size());
            largest = std::max(largest, distance(evaluate(cubics[i], u), evaluate(curve, t)));
        }
    return largest;
}

TEST(CubicPieces, comeBackAsTheyAreUpToDegreeThree) {
    EXPECT_EQ(cubicPieces(Points{{1, 2}}, {0}), (std::vector<Cubic>{{{{1, 2}, {1, 2}, {1, 2}, {1, 2}}}}));
    EXPECT_EQ(cubicPieces(Points{{0, 0}, {3, 6}}, {0}), (std::vector<Cubic>{{{{0, 0}, {1, 2}, {2, 4}, {3, 6}}}}));
    EXPECT_EQ(cubicPieces(Points{{0, 0}, {3, 3}, {6, 0}}, {0}),
              (std::vector<Cubic>{{{{0, 0}, {2, 2}, {4, 2}, {6, 0}}}}));
    const Cubic cubic{{{0.1, 0.2}, {1, 2}, {3, 2}, {0.3, 0.7}}};
    EXPECT_EQ(cubicPieces(cubic, {0}), std::vector<Cubic>{cubic});
}

TEST(CubicPieces, ofRepeatedPointsAreOneCubic) {
    EXPECT_EQ(cubicPieces(Points(201, Point{1e9, 0.1}), {0}).size(), 1U);
}

TEST(CubicPieces, endAtDegree200AndZeroTolerance) {
    Points curve(201);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {i % 3 == 0 ? 1e9 : -1e9, i % 5 == 0 ? 1e9 : -1e9};
    const std::vector<Cubic> cubics = cubicPieces(curve, {1e3});
    EXPECT_LT(cubics.size(), 3000U);
    EXPECT_EQ(cubics.front()[0], curve.front());
    EXPECT_EQ(cubics.back()[3], curve.back());
    // The first eight points are enough to see that a tolerance of zero ends.
    EXPECT_LT(cubicPieces(std::span(curve).first(8), {0}).size(), 20000U);
}

RC_GTEST_PROP(CubicPieces, joinExactlyAndStayWithinTheTolerance, ()) {
    const Points curve = *test::anyCurve(4, 12);
    const double tolerance = *rc::gen::element(10.0, 0.1, 1e-3);
    const std::vector<Cubic> cubics = cubicPieces(curve, {tolerance});
    RC_ASSERT(cubics.front()[0] == curve.front());
    RC_ASSERT(cubics.back()[3] == curve.back());
    for (std::size_t i = 0; i + 1 < cubics.size(); ++i)
        RC_ASSERT(cubics[i][3] == cubics[i + 1][0]);
    const double allowed = tolerance + 1e-9;
    for (const Cubic& cubic : cubics)
        for (const double u : {0.1, 0.3, 0.5, 0.8})
            RC_ASSERT(nearest(curve, evaluate(cubic, u)).distance <= allowed);
    const auto distanceToPieces = [&](Point p) {
        double least = distance(p, curve.front());
        for (const Cubic& cubic : cubics)
            least = std::min(least, nearest(cubic, p).distance);
        return least;
    };
    for (int i = 0; i <= 20; ++i)
        RC_ASSERT(distanceToPieces(evaluate(curve, i / 20.0)) <= allowed);
}

TEST(CubicPieces, followASymmetricCurveAtTheSameParameter) {
    // The degree-4 polynomial t^4: its fourth derivative is constant, so all pieces are equally wide.
    const Points quartic{{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {1, 1}};
    for (const double tolerance : {1e-2, 1e-5, 1e-9}) {
        const std::vector<Cubic> cubics = cubicPieces(quartic, {tolerance});
        EXPECT_LE(sampledDistance(quartic, cubics), tolerance);
    }
}

} // namespace
} // namespace kriva
