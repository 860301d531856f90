#include "ui/editing/sheet/pointed_out.h"

#include <utility>

namespace kriva::ui {

void PointedOut::choose(Points places) {
    const Points before = std::exchange(mine_, places);
    if (!places.empty())
        sheet_.pointOut(std::move(places));
    else if (sheet_.pointedOut() == before)
        sheet_.movePointedOut({});
}

void PointedOut::follow(const Points& places) {
    if (!mine_.empty() && sheet_.pointedOut() == std::exchange(mine_, places))
        sheet_.movePointedOut(places);
}

} // namespace kriva::ui
