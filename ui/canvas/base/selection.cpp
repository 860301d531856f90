#include "ui/canvas/base/selection.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace kriva::ui {

Selection::Selection(std::vector<GripRef> grips)
    : grips_(std::move(grips)) {
    std::ranges::sort(grips_);
    const auto repeated = std::ranges::unique(grips_);
    grips_.erase(repeated.begin(), repeated.end());
}

bool Selection::contains(const GripRef& grip) const {
    return std::ranges::binary_search(grips_, grip);
}

std::span<const GripRef> Selection::ofCurve(Serial serial) const {
    const auto found = std::ranges::equal_range(grips_, serial, {}, &GripRef::serial);
    return {found.begin(), found.end()};
}

void Selection::insert(const GripRef& grip) {
    if (grips_.empty() || grips_.back() < grip) {
        grips_.push_back(grip);
        return;
    }
    const auto place = std::ranges::lower_bound(grips_, grip);
    if (*place != grip)
        grips_.insert(place, grip);
}

void Selection::insertPoints(Serial serial, int first, int end) {
    Selection points;
    points.grips_.reserve(static_cast<std::size_t>(std::max(0, end - first)));
    for (int i = first; i < end; ++i)
        points.grips_.push_back({serial, {GripKind::point, i}});
    *this = empty() ? std::move(points) : united(*this, points);
}

Selection united(const Selection& a, const Selection& b) {
    Selection both;
    both.grips_.reserve(a.size() + b.size());
    std::ranges::set_union(a.grips_, b.grips_, std::back_inserter(both.grips_));
    return both;
}

Selection without(const Selection& selection, const Selection& removed) {
    Selection kept;
    std::ranges::set_difference(selection.grips_, removed.grips_, std::back_inserter(kept.grips_));
    return kept;
}

} // namespace kriva::ui
