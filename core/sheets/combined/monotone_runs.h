#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// Points in a row whose x rises or falls strictly.
struct MonotoneRun {
    int first = 0;
    int last = 0;      ///< the last point itself
    int direction = 0; ///< 1 where x rises, -1 where it falls, 0 for one point
    friend constexpr bool operator==(const MonotoneRun&, const MonotoneRun&) = default;

    [[nodiscard]] constexpr std::size_t size() const { return static_cast<std::size_t>(last - first) + 1; }
};

/// The points of a run among all.
[[nodiscard]] inline std::span<const Point> pointsOf(const MonotoneRun& run, std::span<const Point> points) {
    return points.subspan(static_cast<std::size_t>(run.first), run.size());
}

/// Cuts points, in drawing order, into runs: a point whose x equals the last one's, or to which the step goes against
/// the run's direction, starts the next run; that takes its direction from its own first step.
/// Source: Rossinsky, Kravchenko, Combined algorithm for constructing curves of arbitrary form (2014), step 2.
[[nodiscard]] std::vector<MonotoneRun> monotoneRuns(std::span<const Point> points);

} // namespace kriva
