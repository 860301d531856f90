#include "core/bezier/evaluate.h"
#include "core/bezier/pull.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

const Points kCurve{{0, 0}, {1, 3}, {4, 3}, {5, 0}};

TEST(Pull, bringsThePointWhereItIsPulled) {
    const Vector by{0.5, -0.25};
    for (const double t : {0.1, 0.5, 0.8}) {
        const Points moved = pulled(kCurve, t, by).value();
        EXPECT_LT(distance(evaluate(moved, t), evaluate(kCurve, t) + by), 1e-14);
        EXPECT_EQ(moved.front(), kCurve.front());
        EXPECT_EQ(moved.back(), kCurve.back());
    }
}

TEST(Pull, movesInnerPointsAlikeWhereTheyWeighAlike) {
    const Points moved = pulled(kCurve, 0.5, {0, 3}).value();
    EXPECT_DOUBLE_EQ(moved[1].y, 7);
    EXPECT_DOUBLE_EQ(moved[2].y, 7);
}

TEST(Pull, hasNoAnswerAtTheEndsAndForLines) {
    EXPECT_FALSE(pulled(kCurve, 0, {1, 0}));
    EXPECT_FALSE(pulled(kCurve, 1, {1, 0}));
    EXPECT_FALSE(pulled(Points{{0, 0}, {1, 1}}, 0.5, {1, 0}));
}

} // namespace
} // namespace kriva
