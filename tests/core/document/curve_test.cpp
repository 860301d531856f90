#include "core/document/curve.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

template <class... C>
constexpr bool noneIsMadeSilently(std::type_identity<std::variant<C...>>) {
    return ((std::is_constructible_v<Curve, C> && !std::is_convertible_v<C, Curve> &&
             !std::is_assignable_v<Curve&, C>)&&...);
}
// Or a function for curves of any kind would call itself where a sheet does not have it.
static_assert(noneIsMadeSilently(std::type_identity<CurveKinds>()));
static_assert(!std::is_constructible_v<Curve, int> && !std::is_constructible_v<Curve, Points>);

/// A curve of each kind through the same points.
class EveryKind : public testing::TestWithParam<SheetIndex> {
  protected:
    const Points points{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    const Curve curve = withPointsAdded(emptyCurve(GetParam()), points);
};

TEST_P(EveryKind, knowsItsSheet) {
    EXPECT_EQ(curve.index(), GetParam());
    EXPECT_EQ(pointCount(emptyCurve(GetParam())), 0u);
    EXPECT_TRUE(isIncomplete(emptyCurve(GetParam())));
    EXPECT_FALSE(isIncomplete(curve));
}

TEST_P(EveryKind, givesItsPointsBack) {
    ASSERT_EQ(pointCount(curve), points.size());
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(pointAt(curve, i), points[static_cast<std::size_t>(i)]);
    EXPECT_EQ(pointAt(reversed(curve).curve, 0), points.back());
}

TEST_P(EveryKind, takesAPathByItsPiecesOrByItsPoints) {
    const Curve taken = withPathAdded(emptyCurve(GetParam()), polyline(points));
    EXPECT_EQ(pointCount(taken), points.size());
    EXPECT_EQ(pointAt(taken, 2), points[2]);
}

TEST_P(EveryKind, losesAPointAndIsRefittedWhereItHasPieces) {
    const Refitted<Curve> refitted = withPointsRemovedRefitted(curve, {1});
    EXPECT_EQ(pointCount(refitted.edited.curve), 3u);
    EXPECT_EQ(refitted.edited.map.newIndex, (std::vector<int>{0, IndexMap::kGone, 1, 2}));
    const bool hasPieces = std::visit([](const auto& kind) { return kind.kCapabilities.pieces; }, curve);
    EXPECT_EQ(refitted.deviation.has_value(), hasPieces);
    EXPECT_TRUE(hasPieces || refitted.edited.curve == withPointsRemoved(curve, {1}).curve);
}

TEST_P(EveryKind, isBehindAnotherOfItsKind) {
    const Curve both = appended(curve, curve);
    EXPECT_EQ(pointCount(both), 2 * points.size());
    EXPECT_EQ(both.index(), curve.index());
}

TEST_P(EveryKind, hasANameAStyleAndAView) {
    CurveStyle style;
    style.width = 2;
    const Curve changed = withStyle(withView(renamed(curve, "one\xff"), {false}), style);
    EXPECT_EQ(nameOf(changed), "one\xef\xbf\xbd");
    EXPECT_EQ(styleOf(changed), style);
    EXPECT_FALSE(viewOf(changed).isShown);
    EXPECT_NE(changed, curve);
}

INSTANTIATE_TEST_SUITE_P(OfEachSheet, EveryKind, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva
