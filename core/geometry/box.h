#pragma once

#include "core/geometry/point.h"

#include <algorithm>
#include <limits>

namespace kriva {

/// An axis-parallel box; without points it is empty (xmin > xmax), and uniting with it changes nothing.
struct Box {
    double xmin = std::numeric_limits<double>::infinity();
    double ymin = std::numeric_limits<double>::infinity();
    double xmax = -std::numeric_limits<double>::infinity();
    double ymax = -std::numeric_limits<double>::infinity();
    friend constexpr bool operator==(const Box&, const Box&) = default;

    [[nodiscard]] constexpr bool isEmpty() const { return xmin > xmax || ymin > ymax; }
    [[nodiscard]] constexpr double width() const { return isEmpty() ? 0 : xmax - xmin; }
    [[nodiscard]] constexpr double height() const { return isEmpty() ? 0 : ymax - ymin; }
    [[nodiscard]] constexpr Point centre() const { return midpoint({xmin, ymin}, {xmax, ymax}); }
};

constexpr void extend(Box& box, Point p) {
    box = {std::min(box.xmin, p.x), std::min(box.ymin, p.y), std::max(box.xmax, p.x), std::max(box.ymax, p.y)};
}
[[nodiscard]] constexpr Box united(const Box& a, const Box& b) {
    return {std::min(a.xmin, b.xmin), std::min(a.ymin, b.ymin), std::max(a.xmax, b.xmax), std::max(a.ymax, b.ymax)};
}
[[nodiscard]] constexpr Box boxOf(std::span<const Point> points) {
    Box box;
    for (const Point p : points)
        extend(box, p);
    return box;
}
[[nodiscard]] inline double diagonal(const Box& box) {
    return std::hypot(box.width(), box.height());
}
/// The box with the same margin added on every side.
[[nodiscard]] constexpr Box grown(const Box& box, double margin) {
    return {box.xmin - margin, box.ymin - margin, box.xmax + margin, box.ymax + margin};
}
[[nodiscard]] constexpr bool overlap(const Box& a, const Box& b) {
    return a.xmin <= b.xmax && b.xmin <= a.xmax && a.ymin <= b.ymax && b.ymin <= a.ymax;
}

} // namespace kriva
