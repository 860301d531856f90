#include "core/sheets/combined/monotone_runs.h"

namespace kriva {

std::vector<MonotoneRun> monotoneRuns(std::span<const Point> points) {
    std::vector<MonotoneRun> runs;
    for (int i = 0; static_cast<std::size_t>(i) < points.size(); ++i) {
        int step = 0;
        if (!runs.empty()) {
            const double before = points[static_cast<std::size_t>(i) - 1].x;
            const double x = points[static_cast<std::size_t>(i)].x;
            step = (x > before ? 1 : 0) - (x < before ? 1 : 0);
        }
        if (step == 0 || runs.back().direction == -step) {
            runs.push_back({i, i, 0});
            continue;
        }
        runs.back().last = i;
        runs.back().direction = step;
    }
    return runs;
}

} // namespace kriva
