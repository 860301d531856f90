#include "core/io/svg/paths/map_trail.h"

#include "core/geometry/point.h"

#include <ranges>
#include <utility>

namespace kriva {

const MapTrail::Step* MapTrail::culprit(Point local, double limit) const {
    const Step* culprit = nullptr;
    bool isBeyond = !isWithin(local, limit);
    for (const Step& step : steps_ | std::views::reverse) {
        local = step.map(local);
        const bool wasBeyond = std::exchange(isBeyond, !isWithin(local, limit));
        if (isBeyond && !wasBeyond)
            culprit = &step;
    }
    return culprit;
}

} // namespace kriva
