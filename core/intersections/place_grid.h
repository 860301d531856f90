#pragma once

#include "core/geometry/point.h"

#include <cstddef>
#include <functional>

namespace kriva {

/// Points in square cells, each so small that all in it are closer to each other than a distance.
class PlaceGrid {
  public:
    PlaceGrid(std::span<const Point> points, double distance);

    struct Cell {
        double column = 0; ///< whole numbers
        double row = 0;
        std::size_t first = 0; ///< of the cell's points in the order of the grid
        std::size_t end = 0;
    };
    [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
    /// Of the points in a cell, ascending.
    [[nodiscard]] std::span<const std::size_t> indicesIn(std::size_t cell) const;
    /// Calls back with the points of each other cell that may be within the distance, once for a pair of cells.
    void forEachNeighbour(std::size_t cell, const std::function<void(std::span<const std::size_t>)>& meet) const;

  private:
    std::vector<std::size_t> order_; ///< of the points, by cells
    std::vector<Cell> cells_;        ///< by column and row
};

/// Indices that are put together step by step.
class Clusters {
  public:
    explicit Clusters(std::size_t count);

    void unite(std::size_t i, std::size_t j) { root_[rootOf(i)] = rootOf(j); }
    [[nodiscard]] bool areOne(std::size_t i, std::size_t j) { return rootOf(i) == rootOf(j); }
    /// All clusters, the indices of each ascending.
    [[nodiscard]] std::vector<std::vector<std::size_t>> take();

  private:
    [[nodiscard]] std::size_t rootOf(std::size_t i);

    std::vector<std::size_t> root_;
};

} // namespace kriva
