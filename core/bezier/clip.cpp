#include "core/bezier/clip.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>

namespace kriva {
namespace {

bool contains(const Box& box, Point p) {
    return box.xmin <= p.x && p.x <= box.xmax && box.ymin <= p.y && p.y <= box.ymax;
}

/// Where the curve crosses the line on which a coordinate has this value.
void addCrossings(std::span<const Point> curve, double Point::*coordinate, double value, std::vector<double>& cuts) {
    std::vector<double> distances;
    for (const Point p : curve)
        distances.push_back(p.*coordinate - value);
    const std::vector<double> changes = signChanges(distances);
    cuts.insert(cuts.end(), changes.begin(), changes.end());
}

Point heldIn(const Box& box, Point p) {
    return {std::clamp(p.x, box.xmin, box.xmax), std::clamp(p.y, box.ymin, box.ymax)};
}

} // namespace

std::vector<Points> clipped(std::span<const Point> curve, const Box& box) {
    const Box hull = boxOf(curve);
    if (hull.isEmpty() || box.isEmpty() || !overlap(hull, box))
        return {};
    if (contains(box, {hull.xmin, hull.ymin}) && contains(box, {hull.xmax, hull.ymax}))
        return {Points(curve.begin(), curve.end())};
    std::vector<double> cuts{0};
    if (hull.xmin < box.xmin)
        addCrossings(curve, &Point::x, box.xmin, cuts);
    if (hull.xmax > box.xmax)
        addCrossings(curve, &Point::x, box.xmax, cuts);
    if (hull.ymin < box.ymin)
        addCrossings(curve, &Point::y, box.ymin, cuts);
    if (hull.ymax > box.ymax)
        addCrossings(curve, &Point::y, box.ymax, cuts);
    cuts.push_back(1);
    std::ranges::sort(cuts);
    std::vector<Points> parts;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i - 1] == cuts[i] || !contains(box, evaluate(curve, (cuts[i - 1] + cuts[i]) / 2)))
            continue;
        Points inside = part(curve, cuts[i - 1], cuts[i]);
        inside.front() = heldIn(box, inside.front());
        inside.back() = heldIn(box, inside.back());
        parts.push_back(std::move(inside));
    }
    return parts;
}

} // namespace kriva
