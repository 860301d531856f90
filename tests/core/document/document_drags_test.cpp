#include "core/document/document_drags.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

/// A curve of each kind through the same points.
class EveryCurve : public testing::TestWithParam<SheetIndex> {
  protected:
    EveryCurve() {
        for (const Point at : {Point{0, 0}, Point{1, 2}, Point{3, 2}, Point{4, 0}})
            curve = withPointAdded(std::move(curve), at).curve;
    }
    [[nodiscard]] bool isSpline() const { return std::holds_alternative<SplineCurve>(curve); }

    Curve curve = emptyCurve(GetParam());
};

TEST_P(EveryCurve, takesAPointNearAPlaceOrBehindAPoint) {
    const Point place{2, 1.7};
    for (const auto& edited : {withPointInserted(curve, place), withPointInsertedBehind(curve, 1)}) {
        ASSERT_TRUE(edited);
        EXPECT_EQ(pointCount(edited->curve), 5u);
        const int added = newPointNear(*edited, place);
        EXPECT_EQ(added, 2);
        EXPECT_LT(distance(pointAt(edited->curve, added), place), 1.5);
    }
    EXPECT_FALSE(withPointInsertedBehind(emptyCurve(GetParam()), {}));
}

TEST_P(EveryCurve, isPulledByTheHandlesOfANewPointOrByThePoint) {
    const PulledPoint ready = readyToPull(curve, 3);
    EXPECT_EQ(ready.grip.kind, isSpline() ? GripKind::outHandle : GripKind::point);
    const Curve pulled = withHandleDragged(ready.curve, ready.grip, {{1, 1}});
    const Point place = isSpline() ? Point{4, 0} : Point{5, 1};
    EXPECT_EQ(pointAt(pulled, 3), place);
}

TEST_P(EveryCurve, isMouldedAndClosedWhereItsKindIs) {
    EXPECT_EQ(withCurvePulled(curve, {2, 1.5}, {0, 1}).has_value(), GetParam() != 3);
    EXPECT_EQ(closedAt(curve, 0).has_value(), isSpline());
    EXPECT_EQ(withHandleRetracted(curve, {GripKind::outHandle, 1}).has_value(), isSpline());
    EXPECT_EQ(oppositeHandle(curve, {GripKind::outHandle, 1}).has_value(), isSpline());
}

INSTANTIATE_TEST_SUITE_P(OfEachSheet, EveryCurve, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva
