#include "core/bezier/evaluate.h"
#include "core/geometry/segment.h"
#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/drawing/visible_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace kriva::ui {
namespace {

constexpr double kPenWidth = 2;
constexpr double kMargin = kPenWidth + 2;

[[nodiscard]] double anyCoordinate() {
    return *rc::gen::inRange(-10'000, 10'001) / 1e3;
}
[[nodiscard]] Points anyCurve(int degree) {
    Points curve;
    for (int i = 0; i <= degree; ++i)
        curve.push_back({anyCoordinate(), anyCoordinate()});
    return curve;
}
[[nodiscard]] bool isSeen(QPointF pixel, const Viewport& viewport) {
    return pixel.x() >= 0 && pixel.x() <= viewport.size.width() && pixel.y() >= 0 &&
           pixel.y() <= viewport.size.height();
}
[[nodiscard]] double distanceToPolylines(QPointF pixel, const std::vector<QPolygonF>& polylines) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const QPolygonF& polyline : polylines)
        for (qsizetype i = 1; i < polyline.size(); ++i)
            nearest = std::min(nearest, distanceToSegment(toCore(pixel), toCore(polyline[i - 1]), toCore(polyline[i])));
    return nearest;
}
[[nodiscard]] std::vector<QPolygonF> seenOf(const Path& path, const Viewport& viewport, const Fineness& fineness = {}) {
    FrameLoad load;
    return visiblePolylines(path, viewport, kPenWidth, fineness, load);
}
/// Around the curve's point at t, at a zoom.
[[nodiscard]] Viewport viewAround(const Points& curve, double t, double zoom) {
    return zoomedTo({.scale = 1, .centre = evaluate(curve, t), .size = {1000, 800}, .unitScale = 40}, zoom);
}
void expectWithinView(const std::vector<QPolygonF>& polylines, const Viewport& viewport) {
    for (const QPolygonF& polyline : polylines) {
        EXPECT_GE(polyline.size(), 2);
        for (const QPointF& pixel : polyline) {
            EXPECT_TRUE(std::isfinite(pixel.x()) && std::isfinite(pixel.y()));
            EXPECT_TRUE(pixel.x() >= -kMargin && pixel.x() <= viewport.size.width() + kMargin);
            EXPECT_TRUE(pixel.y() >= -kMargin && pixel.y() <= viewport.size.height() + kMargin);
        }
    }
}

RC_GTEST_PROP(VisiblePath, everySeenPointOfTheCurveLiesOnThePolyline, ()) {
    const Points curve = anyCurve(*rc::gen::inRange(1, 8));
    const double t = *rc::gen::inRange(0, 1001) / 1e3;
    const double zoom = std::pow(10, *rc::gen::inRange(-3, 7));
    const Viewport viewport = viewAround(curve, t, zoom);
    const auto polylines = seenOf(singleCurve(curve), viewport);
    expectWithinView(polylines, viewport);
    for (int i = -25; i <= 25; ++i) {
        const double near = std::clamp(t + i / zoom / 250, 0.0, 1.0);
        const QPointF pixel = viewport.toPixels(evaluate(curve, near));
        if (isSeen(pixel, viewport))
            RC_ASSERT(distanceToPolylines(pixel, polylines) <= 0.46); // tolerance, spacing and what a line stands for
    }
}

RC_GTEST_PROP(VisiblePath, everyPointOfThePolylineLiesOnTheCurve, ()) {
    const Points curve = anyCurve(3);
    const Viewport viewport = viewAround(curve, 0.5, 1);
    QPolygonF exact;
    for (int i = 0; i <= 2'000; ++i)
        exact.append(viewport.toPixels(evaluate(curve, i / 2e3)));
    for (const QPolygonF& polyline : seenOf(singleCurve(curve), viewport))
        for (const QPointF& pixel : polyline)
            RC_ASSERT(distanceToPolylines(pixel, {exact}) <= 0.15);
}

TEST(VisiblePath, aPathOutOfSightHasNoPolyline) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {100, 100}};
    EXPECT_TRUE(seenOf(singleCurve(Points{{200, 0}, {300, 5}, {200, 9}}), viewport).empty());
    EXPECT_TRUE(seenOf(Path(), viewport).empty());
}

TEST(VisiblePath, aPathThatLeavesAndComesBackHasTwoPolylines) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {100, 100}};
    const Points points{{0, 0}, {500, 0}, {500, 20}, {0, 20}};
    EXPECT_EQ(seenOf(polyline(points), viewport).size(), 2U);
}

TEST(VisiblePath, aChainThatStaysInSightIsOnePolyline) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {100, 100}};
    const Path path = chain({{{0, 0}, {10, 20}, {20, 0}}, {{20, 0}, {30, -20}, {40, 0}}}, false);
    const auto polylines = seenOf(path, viewport);
    ASSERT_EQ(polylines.size(), 1U);
    EXPECT_EQ(polylines[0].front(), viewport.toPixels({0, 0}));
    EXPECT_EQ(polylines[0].back(), viewport.toPixels({40, 0}));
}

TEST(VisiblePath, aPieceOfOnePointIsADot) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {100, 100}};
    const auto polylines = seenOf(singleCurve(Points(4, Point{1, 1})), viewport);
    ASSERT_EQ(polylines.size(), 1U);
    EXPECT_EQ(polylines[0], QPolygonF({viewport.toPixels({1, 1}), viewport.toPixels({1, 1})}));
}

TEST(VisiblePath, aStraightCurveThatTurnsBackIsDrawnToItsTurn) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {1000, 100}};
    const Points curve{{0, 0}, {400, 0}, {0, 0}};
    const auto polylines = seenOf(singleCurve(curve), viewport);
    EXPECT_LE(distanceToPolylines(viewport.toPixels(evaluate(curve, 0.5)), polylines), 0.46);
}

TEST(VisiblePath, pointsCloserThanTheSpacingAreLeftOut) {
    Points circle;
    for (int i = 0; i <= 100'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 100'000;
        circle.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
    }
    const Viewport viewport{.scale = 1, .centre = {}, .size = {300, 300}};
    const auto polylines = seenOf(polyline(circle), viewport);
    ASSERT_EQ(polylines.size(), 1U);
    EXPECT_LE(polylines[0].size(), 160); // an arc of 4 pixels is flat within the tolerance
    EXPECT_GT(polylines[0].size(), 30);
    const auto coarse = seenOf(polyline(circle), viewport, {.tolerance = 0.1, .spacing = 4});
    EXPECT_LE(coarse[0].size(), 40);
}

TEST(VisiblePath, theHighestDegreeAndTheFarthestZoomStayFinite) {
    Points curve;
    for (int i = 0; i <= 200; ++i)
        curve.push_back({i % 2 == 0 ? -1e9 : 1e9, 1e9 * std::cos(i)});
    for (const double zoom : {1e-6, 1.0, 1e6, 1e9}) {
        const Viewport viewport =
            zoomedTo({.scale = 1, .centre = evaluate(curve, 0.3), .size = {1000, 800}, .unitScale = 1}, zoom);
        expectWithinView(seenOf(singleCurve(curve), viewport), viewport);
    }
}

} // namespace
} // namespace kriva::ui
