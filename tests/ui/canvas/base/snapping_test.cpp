#include "ui/canvas/base/grid.h"
#include "ui/canvas/base/snapping.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

/// A unit to a pixel, so that the grid's step is 20; a parabola with its top at (0, 50) as curve 1, a point at (200, 7)
/// as curve 2.
class Snapping : public testing::Test {
  protected:
    Snapping() {
        parabola.layers = {{"curve", {{.path = singleCurve(points)}}}};
        for (int i = 0; i < 3; ++i)
            grips.push_back({{GripKind::point, i}, points[static_cast<std::size_t>(i)]});
        grips.push_back({{GripKind::outHandle, 0}, {-100, -60}});
    }
    [[nodiscard]] std::optional<Snap> snap(const SnappingPlace& place, bool hasGrid = true) const {
        const SnapTarget targets[] = {{1, grips, &parabola}, {2, {&alone, 1}, &empty}};
        return snapOf(place, targets, viewport, hasGrid);
    }

    const Points points{{-100, 0}, {0, 100}, {100, 0}};
    std::vector<Grip> grips;
    const Grip alone{{GripKind::point, 0}, {200, 7}};
    Figure parabola;
    Figure empty;
    Viewport viewport{.scale = 1, .centre = {}, .size = {400, 400}, .unitScale = 1};
};

TEST_F(Snapping, takesTheNearestPointWithinReach) {
    EXPECT_EQ(snap({{195, 13}}), (Snap{{200, 7}, SnapKind::point}));
    EXPECT_EQ(snap({{189, 7}})->kind, SnapKind::grid);
    EXPECT_EQ(snap({{5, 92}}), (Snap{{0, 100}, SnapKind::point}));
}

TEST_F(Snapping, reachesAsFarInPixelsAtEveryZoom) {
    viewport.scale = 0.1;
    EXPECT_EQ(snap({{260, -60}}), (Snap{{200, 7}, SnapKind::point}));
    viewport.scale = 10;
    EXPECT_EQ(snap({{201.1, 7}})->kind, SnapKind::grid);
}

TEST_F(Snapping, prefersPointsToCurvesAndCurvesToTheGrid) {
    EXPECT_EQ(snap({{1, 53}}, true)->kind, SnapKind::curve);
    EXPECT_NEAR(distance(snap({{0, 58}})->at, {0, 50}), 0, 1e-9);
    EXPECT_EQ(snap({{-96, 6}}), (Snap{{-100, 0}, SnapKind::point})) << "the curve is nearer";
    EXPECT_EQ(snap({{0, 61}}), (Snap{{0, 60}, SnapKind::grid}));
    EXPECT_EQ(snap({{0, 61}}, false), std::nullopt);
}

TEST_F(Snapping, handlesAndDerivedLinesAttractNothing) {
    EXPECT_EQ(snap({{-99, -60}}), (Snap{{-100, -60}, SnapKind::grid}));
    parabola.layers[0].strokes[0].role = Role::controlPolygon;
    EXPECT_EQ(snap({{0, 53}})->kind, SnapKind::grid);
}

TEST_F(Snapping, passesOverWhatMovesWithThePoint) {
    const GripId moving[] = {{GripKind::point, 1}};
    EXPECT_EQ(snap({{2, 103}, Freedom::both, 1, moving}), (Snap{{0, 100}, SnapKind::grid}));
    EXPECT_EQ(snap({{2, 53}, Freedom::both, 1, moving})->kind, SnapKind::grid) << "its own curve moves";
    EXPECT_EQ(snap({{97, 3}, Freedom::both, 1, moving}), (Snap{{100, 0}, SnapKind::point}));
    EXPECT_EQ(snap({{202, 3}, Freedom::both, 1, moving})->kind, SnapKind::point) << "the same index of another curve";
}

TEST_F(Snapping, keepsToAnAxis) {
    EXPECT_EQ(snap({{196, 3}, Freedom::x}), (Snap{{200, 3}, SnapKind::point}));
    EXPECT_EQ(snap({{196, 3}, Freedom::y}), (Snap{{196, 7}, SnapKind::point}));
    EXPECT_EQ(snap({{43, -77}, Freedom::x}), (Snap{{40, -77}, SnapKind::grid}));
    EXPECT_EQ(snap({{43, -77}, Freedom::y}), (Snap{{43, -80}, SnapKind::grid}));
    // The parabola is 50 - x^2/200 high.
    const std::optional<Snap> across = snap({{64, 32}, Freedom::x});
    EXPECT_EQ(across->kind, SnapKind::curve);
    EXPECT_NEAR(across->at.x, 60, 1e-9);
    EXPECT_EQ(across->at.y, 32);
    EXPECT_NEAR(snap({{60, 27}, Freedom::y})->at.y, 32, 1e-9);
}

TEST_F(Snapping, placesOfTheGridAreRoundNumbers) {
    viewport.scale = 200; // a step of 0.1
    EXPECT_EQ(snap({{10.31, -10.69}})->at, (Point{10.3, -10.7}));
    EXPECT_EQ(nearestMultiple(0.1, 0.3000001), 0.3);
    EXPECT_EQ(nearestMultiple(0.02, -0.1201), -0.12);
    EXPECT_EQ(nearestMultiple(50, 12345), 12350);
    EXPECT_EQ(nearestMultiple(5, 1), 0);
}

} // namespace
} // namespace kriva::ui
