#include "core/bezier/evaluate.h"
#include "ui/canvas/base/hit_test.h"
#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/drawing/visible_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kriva::ui {
namespace {

constexpr GripId point(int index) {
    return {GripKind::point, index, 0};
}

/// A curve with a knot, a handle and a middle point here and there.
struct Curve {
    Points points;
    std::vector<Grip> grips;
    std::vector<QPolygonF> lines;
    std::vector<Layer> layers;
    Points pixels; ///< of the curve, close to each other
};

class HitTest : public ::testing::Test {
  protected:
    /// Curves around the middle of a view at a zoom.
    void makeScene(double zoom, unsigned seed) {
        random.seed(seed);
        viewport = zoomedTo({.scale = 1, .centre = {3, -2}, .size = {900, 700}, .unitScale = 100}, zoom);
        curves.clear();
        for (int i = 0; i < 12; ++i) {
            Curve curve;
            for (int k = 0; k < 4; ++k) {
                curve.points.push_back(viewport.toDocument(anyPixel()));
                curve.grips.push_back({{static_cast<GripKind>(k), i, 0}, curve.points.back()});
            }
            for (int k = 0; k <= 2'000; ++k)
                curve.pixels.push_back(toCore(viewport.toPixels(evaluate(curve.points, k / 2e3))));
            Marks marks{{}, Role::derivedPolygon};
            for (int k = 0; k < 4; ++k)
                marks.at.push_back(viewport.toDocument(anyPixel()));
            curve.layers = {{"elevated-polygon", {}, {marks}}};
            FrameLoad load;
            curve.lines = visiblePolylines(singleCurve(curve.points), viewport, 0, {}, load);
            curves.push_back(std::move(curve));
        }
        targets.clear();
        for (const Curve& curve : curves)
            targets.push_back({targets.size() + 1, targets.empty(), curve.grips, curve.lines, curve.layers});
    }
    QPointF anyPixel() {
        return {std::uniform_real_distribution(0.0, 900.0)(random), std::uniform_real_distribution(0.0, 700.0)(random)};
    }
    double distanceTo(const Point& p, QPointF pixel) const {
        const QPointF way = viewport.toPixels(p) - pixel;
        return std::hypot(way.x(), way.y());
    }
    /// Straight from the rules, by looking at every grip and at thousands of points of every curve.
    Hit bruteForce(QPointF pixel) const {
        Hit hit;
        double nearest = 10;
        for (const HitTarget& target : targets)
            for (const Grip& grip : target.grips)
                if (distanceTo(grip.at, pixel) <= nearest) {
                    nearest = distanceTo(grip.at, pixel);
                    hit.grip = {target.serial, grip.id};
                }
        if (hit.grip)
            return hit;
        nearest = 6;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const double away = distanceToCurve(pixel, curves[i]);
            if (away < nearest) {
                nearest = away;
                hit.curve = targets[i].serial;
            }
        }
        nearest = 6;
        for (const Curve& curve : curves)
            for (const Point at : curve.layers[0].marks[0].at)
                if (distanceTo(at, pixel) <= nearest) {
                    nearest = distanceTo(at, pixel);
                    hit.mark = {Role::derivedPolygon, at};
                }
        return hit;
    }
    static double distanceToCurve(QPointF pixel, const Curve& curve) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Point p : curve.pixels)
            nearest = std::min(nearest, dot(p - toCore(pixel), p - toCore(pixel)));
        return std::sqrt(nearest);
    }
    /// Whether two answers are so close to each other that rounding and flattening may choose.
    bool isCloseCall(QPointF pixel, const Hit& one, const Hit& other) const {
        return std::abs(distanceOf(pixel, one) - distanceOf(pixel, other)) < 0.6;
    }
    double distanceOf(QPointF pixel, const Hit& hit) const {
        if (hit.grip)
            return distanceTo(curves[hit.grip->serial - 1].grips[static_cast<std::size_t>(hit.grip->id.kind)].at,
                              pixel);
        if (!hit.curve)
            return 6;
        return distanceToCurve(pixel, curves[*hit.curve - 1]);
    }

    std::mt19937 random;
    Viewport viewport;
    std::vector<Curve> curves;
    std::vector<HitTarget> targets;
};

TEST_F(HitTest, agreesWithBruteForceOnAThousandPicksAtEveryZoom) {
    for (const double zoom : {1e-3, 1.0, 1e3}) {
        makeScene(zoom, 7);
        int hits = 0;
        int closeCalls = 0;
        int marks = 0;
        for (int i = 0; i < 1'000; ++i) {
            // Half of the picks are near a grip or a mark, where most is to be decided.
            const Point p = curves[static_cast<std::size_t>(i) % curves.size()].points[static_cast<std::size_t>(i) % 4];
            const Point mark = curves[static_cast<std::size_t>(i) % curves.size()].layers[0].marks[0].at[0];
            const QPointF pixel =
                i % 2 == 0 ? anyPixel()
                           : viewport.toPixels(i % 4 == 1 ? p : mark) + (anyPixel() - QPointF(450, 350)) / 40;
            const Hit found = hitAt(pixel, targets, viewport, {});
            const Hit expected = bruteForce(pixel);
            hits += expected != Hit();
            marks += expected.mark.has_value();
            if (found == expected)
                continue;
            EXPECT_EQ(found.mark, expected.mark) << "zoom " << zoom << ", pick " << i;
            ++closeCalls;
            EXPECT_TRUE(isCloseCall(pixel, found, expected)) << "zoom " << zoom << ", pick " << i;
        }
        EXPECT_GT(hits, 350);
        EXPECT_GT(marks, 50);
        EXPECT_LT(closeCalls, 20);
    }
}

TEST_F(HitTest, gripsWithinTenPixelsWinOverCurves) {
    viewport = {.scale = 1, .centre = {}, .size = {200, 200}};
    const std::vector<Grip> grips{{point(0), {9.5, 0}}};
    const std::vector<QPolygonF> lines{QPolygonF({{0, 100}, {200, 100}})};
    targets = {{1, true, grips, lines}};
    EXPECT_EQ(hitAt({100, 100}, targets, viewport, {}).grip, (GripRef{1, point(0)}));
    EXPECT_EQ(hitAt({98, 100}, targets, viewport, {}).curve, 1U);
    EXPECT_EQ(hitAt({98, 94.1}, targets, viewport, {}).curve, 1U);
    EXPECT_EQ(hitAt({98, 93.9}, targets, viewport, {}), Hit());
}

TEST_F(HitTest, inOnePlaceTheSelectedWinsThenTheKnotThenTheActiveCurve) {
    viewport = {.scale = 1, .centre = {}, .size = {200, 200}};
    const GripId handle{GripKind::outHandle, 0, 0};
    const std::vector<Grip> grips{{handle, {0, 0}}, {point(0), {0, 0}}};
    const std::vector<Grip> others{{point(0), {0, 0}}};
    targets = {{1, true, grips, {}}, {2, false, others, {}}};
    const QPointF pixel(103, 100);
    EXPECT_EQ(hitAt(pixel, targets, viewport, {}).grip, (GripRef{1, point(0)}));
    EXPECT_EQ(hitAt(pixel, targets, viewport, {{1, handle}}).grip, (GripRef{1, handle}));
    EXPECT_EQ(hitAt(pixel, targets, viewport, {{2, point(0)}}).grip, (GripRef{2, point(0)}));
}

TEST_F(HitTest, theNearerGripWinsOverTheSelectedOne) {
    viewport = {.scale = 1, .centre = {}, .size = {200, 200}};
    const std::vector<Grip> grips{{point(0), {0, 0}}, {point(1), {8, 0}}};
    targets = {{1, true, grips, {}}};
    EXPECT_EQ(hitAt({107, 100}, targets, viewport, {{1, point(0)}}).grip, (GripRef{1, point(1)}));
}

TEST_F(HitTest, ofEquallyNearCurvesTheActiveOneWins) {
    const std::vector<QPolygonF> lines{QPolygonF({{0, 100}, {200, 100}})};
    targets = {{1, false, {}, lines}, {2, true, {}, lines}, {3, false, {}, lines}};
    EXPECT_EQ(hitAt({50, 102}, targets, viewport, {}).curve, 2U);
}

TEST_F(HitTest, aRectangleHoldsThePointsOnItsEdgeAndNoHandles) {
    viewport = {.scale = 1, .centre = {}, .size = {200, 200}};
    const std::vector<Grip> grips{
        {point(0), {0, 0}}, {point(1), {50, 0}}, {point(2), {51, 0}}, {{GripKind::inHandle, 0, 0}, {10, 0}}};
    targets = {{4, true, grips, {}}};
    EXPECT_EQ(pointsIn({100, 90, 50, 20}, targets, viewport), (Selection{{4, point(0)}, {4, point(1)}}));
}

} // namespace
} // namespace kriva::ui
