#include "core/intersections/place_grid.h"
#include "tests/support/any_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <map>

namespace kriva {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

/// In which cell each point is.
std::vector<std::size_t> cellsOfPoints(const PlaceGrid& grid, std::size_t count) {
    std::vector<std::size_t> cells(count, grid.cells().size());
    for (std::size_t cell = 0; cell < grid.cells().size(); ++cell)
        for (const std::size_t i : grid.indicesIn(cell))
            cells.at(i) = cell;
    return cells;
}

/// How often the grid tells each pair of points as neighbours, the smaller index first.
std::map<std::pair<std::size_t, std::size_t>, int> neighboursIn(const PlaceGrid& grid) {
    std::map<std::pair<std::size_t, std::size_t>, int> pairs;
    for (std::size_t cell = 0; cell < grid.cells().size(); ++cell)
        grid.forEachNeighbour(cell, [&](std::span<const std::size_t> others) {
            for (const std::size_t i : grid.indicesIn(cell))
                for (const std::size_t j : others)
                    ++pairs[std::minmax(i, j)];
        });
    return pairs;
}

/// Points that crowd in a few cells.
Points crowdedPoints() {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-320, 320), [](int i) { return i / 64.0; });
    return *rc::gen::container<Points>(rc::gen::map(rc::gen::pair(coordinate, coordinate), [](const auto& xy) {
        return Point{xy.first, xy.second};
    }));
}

double anyDistance() {
    return *rc::gen::elementOf(std::vector{1e-3, 0.3, 1.0, 1.7, 5.0});
}

RC_GTEST_PROP(PlaceGrid, hasEachPointInOneCellAscending, ()) {
    const Points points = crowdedPoints();
    const PlaceGrid grid(points, anyDistance());
    std::vector<std::size_t> all;
    for (std::size_t cell = 0; cell < grid.cells().size(); ++cell) {
        const auto own = grid.indicesIn(cell);
        RC_ASSERT(!own.empty());
        RC_ASSERT(std::ranges::is_sorted(own));
        all.insert(all.end(), own.begin(), own.end());
    }
    std::ranges::sort(all);
    RC_ASSERT(all.size() == points.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        RC_ASSERT(all[i] == i);
}

RC_GTEST_PROP(PlaceGrid, hasPointsOfOneCellCloserThanTheDistance, ()) {
    const Points points = crowdedPoints();
    const double most = anyDistance();
    const PlaceGrid grid(points, most);
    for (std::size_t cell = 0; cell < grid.cells().size(); ++cell)
        for (const std::size_t i : grid.indicesIn(cell))
            for (const std::size_t j : grid.indicesIn(cell))
                RC_ASSERT(distance(points[i], points[j]) < most);
}

RC_GTEST_PROP(PlaceGrid, tellsNeighboursOnceAndMissesNone, ()) {
    const Points points = crowdedPoints();
    const double most = anyDistance();
    const PlaceGrid grid(points, most);
    const auto cells = cellsOfPoints(grid, points.size());
    const auto told = neighboursIn(grid);
    for (const auto& [pair, times] : told) {
        RC_ASSERT(times == 1);
        RC_ASSERT(cells[pair.first] != cells[pair.second]);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if (cells[i] != cells[j] && distance(points[i], points[j]) <= most)
                RC_ASSERT(told.contains({i, j}));
}

TEST(PlaceGrid, isEmptyWithoutPoints) {
    const PlaceGrid grid({}, 1);
    EXPECT_THAT(grid.cells(), IsEmpty());
}

TEST(PlaceGrid, tellsNoNeighboursFarAway) {
    // 100 points in a row, each ten distances from the next one.
    Points row;
    for (int i = 0; i < 100; ++i)
        row.push_back({10.0 * i, 1e9});
    const PlaceGrid grid(row, 1);
    EXPECT_THAT(grid.cells(), SizeIs(100));
    EXPECT_THAT(neighboursIn(grid), IsEmpty());
}

TEST(PlaceGrid, worksFarFromTheOriginForShortDistances) {
    const Points points{{1e6, -1e6}, {1e6 + 1e-8, -1e6}, {1e6, -1e6 + 3e-8}, {-1e6, 1e6}};
    const PlaceGrid grid(points, 2e-8);
    const auto cells = cellsOfPoints(grid, points.size());
    const auto told = neighboursIn(grid);
    EXPECT_TRUE(cells[0] == cells[1] || told.contains({0, 1}));
    EXPECT_FALSE(cells[0] == cells[2]);
    EXPECT_FALSE(told.contains({0, 3}));
}

TEST(Clusters, areSingleAtFirst) {
    Clusters clusters(3);
    EXPECT_TRUE(clusters.areOne(1, 1));
    EXPECT_FALSE(clusters.areOne(0, 1));
    EXPECT_THAT(clusters.take(), UnorderedElementsAre(ElementsAre(0), ElementsAre(1), ElementsAre(2)));
    EXPECT_THAT(Clusters(0).take(), IsEmpty());
}

TEST(Clusters, growByUnitingAnyOfTheirs) {
    Clusters clusters(6);
    clusters.unite(5, 0);
    clusters.unite(3, 1);
    clusters.unite(0, 3);
    clusters.unite(1, 5);
    EXPECT_TRUE(clusters.areOne(5, 1));
    EXPECT_FALSE(clusters.areOne(5, 2));
    EXPECT_THAT(clusters.take(), UnorderedElementsAre(ElementsAre(0, 1, 3, 5), ElementsAre(2), ElementsAre(4)));
}

RC_GTEST_PROP(Clusters, areWhatPathsOfPairsReach, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 30);
    const auto index = rc::gen::inRange<std::size_t>(0, count);
    const auto pairs =
        *rc::gen::container<std::vector<std::pair<std::size_t, std::size_t>>>(rc::gen::pair(index, index));
    Clusters clusters(count);
    std::vector<std::size_t> names(count); // the least index reached
    for (std::size_t i = 0; i < count; ++i)
        names[i] = i;
    for (const auto& [i, j] : pairs) {
        clusters.unite(i, j);
        const std::size_t least = std::min(names[i], names[j]), other = std::max(names[i], names[j]);
        std::ranges::replace(names, other, least);
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            RC_ASSERT(clusters.areOne(i, j) == (names[i] == names[j]));
    std::size_t taken = 0;
    for (const std::vector<std::size_t>& cluster : clusters.take()) {
        RC_ASSERT(!cluster.empty());
        RC_ASSERT(std::ranges::is_sorted(cluster));
        for (const std::size_t i : cluster)
            RC_ASSERT(names[i] == cluster.front());
        taken += cluster.size();
    }
    RC_ASSERT(taken == count);
}

} // namespace
} // namespace kriva
