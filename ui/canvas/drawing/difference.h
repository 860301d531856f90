#pragma once

#include "core/figure/label_placement.h"
#include "core/geometry/box.h"
#include "ui/canvas/drawing/prepared_stroke.h"
#include "ui/canvas/drawing/stamps.h"

/// Where two states of a drawing differ: outside of the box, in pixels, both look the same. So a drag paints no
/// more of a long curve than what it moves.
namespace kriva::ui {

[[nodiscard]] Box difference(const PreparedStroke& before, const PreparedStroke& after);
[[nodiscard]] Box difference(const Stamps& before, const Stamps& after, double devicePixelRatio);
[[nodiscard]] Box difference(const std::vector<PlacedLabel>& before, const std::vector<PlacedLabel>& after);

/// Of lists of these, one by one; what one list has and the other has not is all different.
template <class Element, class... Options>
[[nodiscard]] Box differenceOfEach(const std::vector<Element>& before, const std::vector<Element>& after,
                                   Options... options) {
    Box changed;
    for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i)
        changed = united(changed, difference(i < before.size() ? before[i] : Element(),
                                             i < after.size() ? after[i] : Element(), options...));
    return changed;
}

} // namespace kriva::ui
