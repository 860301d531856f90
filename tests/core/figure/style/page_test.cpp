#include "core/figure/style/page.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace kriva {
namespace {

TEST(Page, hasALongerSideOf120Millimetres) {
    const Page wide = pageOf({0, 0, 4, 2});
    EXPECT_DOUBLE_EQ(wide.width, 120);
    EXPECT_DOUBLE_EQ(wide.height, 54 + 2 * kPageMargin);
    const Page high = pageOf({-1e9, -1e9, -1e9 + 2, -1e9 + 4});
    EXPECT_DOUBLE_EQ(high.height, 120);
}

TEST(Page, takesTheScaleThatIsSet) {
    const Page page = pageOf({0, 0, 4, 2}, 10, 3);
    EXPECT_DOUBLE_EQ(page.width, 46);
    EXPECT_DOUBLE_EQ(page.height, 26);
}

TEST(Page, turnsTheYAxisDown) {
    const Page page = pageOf({0, 0, 4, 2});
    EXPECT_EQ(onPage(page, {0, 2}), (Point{kPageMargin, kPageMargin}));
    EXPECT_EQ(onPage(page, {4, 0}), (Point{120 - kPageMargin, 54 + kPageMargin}));
}

TEST(Page, isMarginAloneWithoutSize) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    for (const Box& box : {Box{}, Box{3, 4, 3, 4}, Box{0, 0, tiny, tiny}}) {
        const Page page = pageOf(box);
        EXPECT_EQ(page.mmPerUnit, 1);
        EXPECT_DOUBLE_EQ(page.width, 2 * kPageMargin);
        EXPECT_DOUBLE_EQ(page.height, 2 * kPageMargin);
    }
}

TEST(Page, holdsAStraightLine) {
    const Page page = pageOf({1, 5, 3, 5});
    EXPECT_DOUBLE_EQ(page.width, 120);
    EXPECT_DOUBLE_EQ(page.height, 2 * kPageMargin);
    EXPECT_EQ(onPage(page, {1, 5}), (Point{kPageMargin, kPageMargin}));
}

RC_GTEST_PROP(Page, keepsEveryPointOfTheBoxInsideTheMargin, ()) {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-1'000'000, 1'000'000), [](int n) { return n * 997.3; });
    const Point a{*coordinate, *coordinate};
    const Point b{*coordinate, *coordinate};
    const Page page = pageOf(boxOf(Points{a, b}));
    constexpr double kRounding = 1e-10;
    for (const Point p : {a, b, midpoint(a, b)}) {
        const Point placed = onPage(page, p);
        RC_ASSERT(placed.x >= kPageMargin - kRounding && placed.x <= page.width - kPageMargin + kRounding);
        RC_ASSERT(placed.y >= kPageMargin - kRounding && placed.y <= page.height - kPageMargin + kRounding);
    }
}

} // namespace
} // namespace kriva
