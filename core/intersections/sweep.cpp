#include "core/intersections/sweep.h"

#include <numeric>

namespace kriva {
namespace {

/// Boxes that are compared within one step.
constexpr std::size_t kComparisons = 16;

} // namespace

void forEachOverlap(std::span<const Box> boxes, WorkBudget& budget,
                    const std::function<void(std::size_t, std::size_t)>& meet) {
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return boxes[i].xmin; });
    std::vector<std::size_t> open; // boxes that reach the current x
    for (const std::size_t i : order) {
        if (!budget.spend(1 + open.size() / kComparisons))
            return;
        std::size_t kept = 0;
        for (const std::size_t j : open) {
            if (boxes[j].xmax < boxes[i].xmin)
                continue;
            open[kept++] = j;
            if (boxes[i].ymin > boxes[j].ymax || boxes[j].ymin > boxes[i].ymax)
                continue;
            meet(std::min(i, j), std::max(i, j));
            if (budget.end())
                return;
        }
        open.resize(kept);
        open.push_back(i);
    }
}

} // namespace kriva
