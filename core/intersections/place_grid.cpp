#include "core/intersections/place_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace kriva {
namespace {

/// Cells to a distance: the diagonal of a cell is shorter.
constexpr int kReach = 2;

std::pair<double, double> keyOf(const PlaceGrid::Cell& cell) {
    return {cell.column, cell.row};
}

} // namespace

PlaceGrid::PlaceGrid(std::span<const Point> points, double distance)
    : order_(points.size()) {
    const double side = distance / kReach;
    std::vector<std::pair<double, double>> keys;
    keys.reserve(points.size());
    for (const Point p : points)
        keys.emplace_back(std::floor(p.x / side), std::floor(p.y / side));
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    std::ranges::sort(order_, {}, [&](std::size_t i) { return std::tuple(keys[i], i); });
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const auto [column, row] = keys[order_[k]];
        if (cells_.empty() || keyOf(cells_.back()) != std::pair(column, row))
            cells_.push_back({column, row, k, k});
        ++cells_.back().end;
    }
}

std::span<const std::size_t> PlaceGrid::indicesIn(std::size_t cell) const {
    return std::span(order_).subspan(cells_[cell].first, cells_[cell].end - cells_[cell].first);
}

void PlaceGrid::forEachNeighbour(std::size_t cell,
                                 const std::function<void(std::span<const std::size_t>)>& meet) const {
    const auto [column, row] = keyOf(cells_[cell]);
    const auto meetIn = [&](std::size_t next, double ofColumn) {
        for (; next < cells_.size() && keyOf(cells_[next]) <= std::pair(ofColumn, row + kReach); ++next)
            meet(indicesIn(next));
    };
    meetIn(cell + 1, column); // those above in the same column, then the columns to the right
    for (int right = 1; right <= kReach; ++right) {
        const auto from = std::ranges::lower_bound(cells_, std::pair(column + right, row - kReach), {}, keyOf);
        meetIn(static_cast<std::size_t>(from - cells_.begin()), column + right);
    }
}

Clusters::Clusters(std::size_t count)
    : root_(count) {
    std::iota(root_.begin(), root_.end(), std::size_t(0));
}

std::size_t Clusters::rootOf(std::size_t i) {
    while (root_[i] != i)
        i = root_[i] = root_[root_[i]];
    return i;
}

std::vector<std::vector<std::size_t>> Clusters::take() {
    std::vector<std::vector<std::size_t>> byRoot(root_.size());
    for (std::size_t i = 0; i < root_.size(); ++i)
        byRoot[rootOf(i)].push_back(i);
    std::erase_if(byRoot, [](const auto& cluster) { return cluster.empty(); });
    return byRoot;
}

} // namespace kriva
