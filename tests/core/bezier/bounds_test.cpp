#include "core/bezier/bounds.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

TEST(TightBounds, ofACubicArch) {
    EXPECT_EQ(tightBounds(Points{{0, 0}, {1, 2}, {3, 2}, {4, 0}}), (Box{0, 0, 4, 1.5}));
}

TEST(TightBounds, ofNothingIsEmptyAndOfOnePointThatPoint) {
    EXPECT_TRUE(tightBounds(Points{}).isEmpty());
    EXPECT_EQ(tightBounds(Points{{0.1, 0.3}}), (Box{0.1, 0.3, 0.1, 0.3}));
    EXPECT_EQ(tightBounds(Points(5, Point{0.1, 0.3})), (Box{0.1, 0.3, 0.1, 0.3}));
}

TEST(TightBounds, ofALineThatTurnsBack) {
    // x = 3 t (1 - t)^2 + 3 t^2 (1 - t) (-1) has its extremes where 1 - 6 t + 6 t^2 = 0.
    const Box box = tightBounds(Points{{0, 0}, {1, 0}, {-1, 0}, {0, 0}});
    const double t = 0.5 - std::sqrt(1.0 / 12);
    const double extreme = 3 * t * (1 - t) * (1 - 2 * t);
    EXPECT_NEAR(box.xmax, extreme, 1e-15);
    EXPECT_NEAR(box.xmin, -extreme, 1e-15);
    EXPECT_EQ(box.height(), 0);
}

TEST(TightBounds, meetsTheEndsBitForBitFarFromTheOrigin) {
    const Points curve{{1e9 + 0.1, 0.3}, {1e9 + 5, 0.4}, {1e9 + 7, 0.6}, {1e9 + 9.7, 0.7}};
    EXPECT_EQ(tightBounds(curve), (Box{1e9 + 0.1, 0.3, 1e9 + 9.7, 0.7}));
}

TEST(TightBounds, ofDegree200) {
    Points curve(201);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = {static_cast<double>(i), i == 100 ? 1.0 : 0.0};
    // y is the middle Bernstein polynomial, largest at 1/2.
    EXPECT_NEAR(tightBounds(curve).ymax, bernstein(200, 0.5)[100], 1e-15);
    EXPECT_EQ(tightBounds(curve).ymin, 0);
    EXPECT_EQ(tightBounds(curve).xmax, 200);
}

RC_GTEST_PROP(TightBounds, holdTheCurveAndTouchItOnEverySide, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Box box = tightBounds(curve);
    Box sampled;
    for (int i = 0; i <= 2000; ++i)
        extend(sampled, evaluate(curve, i / 2000.0));
    // Next to an extreme a sample misses at most (1/4000)^2 / 2 of the second derivative.
    double bend = 0;
    for (std::size_t i = 0; i + 2 < curve.size(); ++i)
        bend = std::max(bend, length((curve[i + 2] - curve[i + 1]) - (curve[i + 1] - curve[i])));
    const auto degree = static_cast<double>(curve.size() - 1);
    const double missed = degree * (degree - 1) * bend / 3.2e7 + 1e-10;
    const double rounding = 1e-12 * 3000;
    RC_ASSERT(box.xmin <= sampled.xmin + rounding && sampled.xmin - missed <= box.xmin);
    RC_ASSERT(box.ymin <= sampled.ymin + rounding && sampled.ymin - missed <= box.ymin);
    RC_ASSERT(box.xmax >= sampled.xmax - rounding && sampled.xmax + missed >= box.xmax);
    RC_ASSERT(box.ymax >= sampled.ymax - rounding && sampled.ymax + missed >= box.ymax);
}

RC_GTEST_PROP(TightBounds, ofTheHalvesUniteToTheWhole, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Halves halves = split(curve, 0.375);
    const Box whole = tightBounds(curve);
    const Box both = united(tightBounds(halves.left), tightBounds(halves.right));
    for (const double difference :
         {whole.xmin - both.xmin, whole.ymin - both.ymin, whole.xmax - both.xmax, whole.ymax - both.ymax})
        RC_ASSERT(std::abs(difference) <= 1e-12 * 3000);
}

} // namespace
} // namespace kriva
