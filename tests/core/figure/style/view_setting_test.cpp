#include "core/figure/style/view_setting.h"

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr ViewSetting kScale{.name = "scale", .least = 0.5, .most = 2, .usual = 1};
constexpr ViewSetting kPlaces{.name = "places", .least = 0, .most = 1, .mostNumbers = 3};

TEST(ViewSetting, hasTheUsualNumberWhereNothingElseIsSaid) {
    const SheetView view;
    EXPECT_EQ(numberOf(nullptr, kScale), 1);
    EXPECT_EQ(numberOf(&view, kScale), 1);
    EXPECT_THAT(numbersOf(nullptr, kPlaces), IsEmpty());
    EXPECT_THAT(numbersOf(&view, kPlaces), IsEmpty());
}

TEST(ViewSetting, isThatOfTheView) {
    const SheetView view = withNumbers(withNumbers({}, kScale, {1.5}), kPlaces, {0.25, 0.75});
    EXPECT_EQ(numberOf(&view, kScale), 1.5);
    EXPECT_THAT(numbersOf(&view, kPlaces), ElementsAre(0.25, 0.75));
}

TEST(ViewSetting, leavesNothingBehindWhereItIsTheUsual) {
    EXPECT_EQ(withNumbers(withNumbers({}, kScale, {1.5}), kScale, {1}), SheetView());
    EXPECT_EQ(withNumbers(withNumbers({}, kPlaces, {0.5}), kPlaces, {}), SheetView());
}

} // namespace
} // namespace kriva
