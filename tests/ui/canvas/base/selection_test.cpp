#include "ui/canvas/base/selection.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

namespace kriva::ui {
namespace {

using Grips = std::vector<std::tuple<int, int, int>>;

std::vector<GripRef> gripsOf(const Grips& numbers) {
    std::vector<GripRef> grips;
    for (const auto& [serial, kind, index] : numbers)
        grips.push_back({static_cast<Serial>(std::abs(serial % 3)),
                         {kGripKinds[static_cast<std::size_t>(std::abs(kind % 7))], std::abs(index % 9)}});
    return grips;
}

RC_GTEST_PROP(SelectionProperty, isASetInOrder, (const Grips& first, const Grips& second)) {
    const std::vector<GripRef> one = gripsOf(first);
    const std::vector<GripRef> other = gripsOf(second);
    std::set<GripRef> united_(one.begin(), one.end());
    Selection byInserting;
    for (const GripRef& grip : one)
        byInserting.insert(grip);
    const Selection selection(one);
    RC_ASSERT(selection == byInserting);
    RC_ASSERT(std::ranges::equal(selection, united_));
    for (const GripRef& grip : other)
        RC_ASSERT(selection.contains(grip) == united_.contains(grip));
    std::set<GripRef> left = united_;
    for (const GripRef& grip : other)
        left.erase(grip);
    united_.insert(other.begin(), other.end());
    RC_ASSERT(std::ranges::equal(united(selection, Selection(other)), united_));
    RC_ASSERT(std::ranges::equal(without(selection, Selection(other)), left));
    for (const Serial serial : {0, 1, 2, 3}) {
        std::vector<GripRef> ofCurve;
        std::ranges::copy_if(selection, std::back_inserter(ofCurve),
                             [&](const GripRef& grip) { return grip.serial == serial; });
        RC_ASSERT(std::ranges::equal(selection.ofCurve(serial), ofCurve));
    }
}

TEST(Selection, pointsOfACurveComeFirstAndInOrder) {
    Selection selection{{2, {GripKind::inHandle, 0}}, {2, {GripKind::point, 7}}, {1, {GripKind::point, 9}}};
    selection.insertPoints(2, 3, 6);
    selection.insertPoints(2, 5, 7);
    std::vector<int> points;
    for (const GripRef& grip : selection.ofCurve(2))
        points.push_back(grip.id.index);
    EXPECT_EQ(points, (std::vector<int>{3, 4, 5, 6, 7, 0}));
    EXPECT_EQ(selection.size(), 7u);
    selection.insertPoints(2, 4, 4);
    EXPECT_EQ(selection.size(), 7u);
}

} // namespace
} // namespace kriva::ui
