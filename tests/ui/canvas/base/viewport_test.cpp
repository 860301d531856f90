#include "core/curve/limits.h"
#include "ui/canvas/base/viewport.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace kriva::ui {
namespace {

/// A number from -1 to 1.
[[nodiscard]] double anyPart() {
    return *rc::gen::inRange(-1'000'000, 1'000'001) / 1e6;
}
[[nodiscard]] Viewport anyViewport() {
    Viewport viewport;
    viewport.size = {*rc::gen::inRange(1, 4000) * 1.0, *rc::gen::inRange(1, 4000) * 1.0};
    viewport.unitScale = std::pow(10, 1 + anyPart());
    viewport.centre = {100 * anyPart(), 100 * anyPart()};
    return zoomedTo(viewport, std::pow(10, 1.5 + 4.5 * anyPart())); // what is seen is within the model's limits
}
[[nodiscard]] QPointF anyPixel(const Viewport& viewport) {
    return {viewport.size.width() * (1 + anyPart()) / 2, viewport.size.height() * (1 + anyPart()) / 2};
}
/// A rounding of the document's coordinates, in pixels.
[[nodiscard]] double grainOf(const Viewport& viewport) {
    return 1e-9 + 1e-12 * viewport.scale * (100 + viewport.size.width() / viewport.scale);
}
[[nodiscard]] double distance(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

RC_GTEST_PROP(Viewport, aPixelComesBackFromTheDocument, ()) {
    const Viewport viewport = anyViewport();
    const QPointF pixel = anyPixel(viewport);
    RC_ASSERT(distance(viewport.toPixels(viewport.toDocument(pixel)), pixel) <= grainOf(viewport));
}

RC_GTEST_PROP(Viewport, whatIsUnderThePixelStaysThereWhileZooming, ()) {
    const Viewport viewport = anyViewport();
    const QPointF pixel = anyPixel(viewport);
    const Viewport zoomed = zoomedAt(viewport, pixel, std::pow(10, 2 * anyPart()));
    RC_ASSERT(distance(zoomed.toPixels(viewport.toDocument(pixel)), pixel) <= grainOf(zoomed) + grainOf(viewport));
}

RC_GTEST_PROP(Viewport, panningMovesEverythingByThosePixels, ()) {
    const Viewport viewport = anyViewport();
    const QPointF way(500 * anyPart(), 500 * anyPart());
    const QPointF pixel = anyPixel(viewport);
    const Point p = viewport.toDocument(pixel);
    RC_ASSERT(distance(panned(viewport, way).toPixels(p), pixel + way) <= 2 * grainOf(viewport));
}

RC_GTEST_PROP(Viewport, aFittedBoxFillsTheViewToItsMargin, ()) {
    Viewport viewport = anyViewport();
    viewport.size = {800, 600};
    Box box;
    extend(box, {100 * anyPart(), 100 * anyPart()});
    extend(box, {100 * anyPart(), 100 * anyPart()});
    RC_PRE(box.width() > 1e-3 && box.height() > 1e-3);
    const Viewport result = fitted(viewport, box, 40);
    const QPointF topLeft = result.toPixels({box.xmin, box.ymax});
    const QPointF bottomRight = result.toPixels({box.xmax, box.ymin});
    RC_ASSERT(topLeft.x() >= 40 - 1e-6 && topLeft.y() >= 40 - 1e-6);
    RC_ASSERT(bottomRight.x() <= 760 + 1e-6 && bottomRight.y() <= 560 + 1e-6);
    RC_ASSERT(topLeft.x() < 40 + 1e-6 || topLeft.y() < 40 + 1e-6);
}

TEST(Viewport, yGrowsUpwards) {
    const Viewport viewport{.scale = 10, .centre = {1, 2}, .size = {200, 100}};
    EXPECT_EQ(viewport.toPixels({1, 2}), QPointF(100, 50));
    EXPECT_EQ(viewport.toPixels({2, 3}), QPointF(110, 40));
}

TEST(Viewport, zoomStaysWithinItsLimits) {
    Viewport viewport{.scale = 2, .centre = {}, .size = {800, 600}, .unitScale = 2};
    for (int i = 0; i < 300; ++i)
        viewport = zoomedAt(viewport, {10, 10}, 1.25);
    EXPECT_DOUBLE_EQ(viewport.zoom(), kLargestZoom);
    for (int i = 0; i < 300; ++i)
        viewport = zoomedAt(viewport, {10, 10}, 0.8);
    EXPECT_DOUBLE_EQ(viewport.zoom(), kSmallestZoom);
}

TEST(Viewport, noPixelLeadsOutOfTheLimitsOfTheModel) {
    const Viewport viewport{.scale = 1e-9, .centre = {limits::kNumber, -limits::kNumber}, .size = {800, 600}};
    EXPECT_EQ(viewport.toDocument({1e300, 1e300}), (Point{limits::kNumber, -limits::kNumber}));
    EXPECT_EQ(panned(viewport, {-1e300, 0}).centre.x, limits::kNumber);
}

TEST(Viewport, pixelsAreFiniteForEveryPointOfTheModelAndEveryScale) {
    for (const double unitScale : {1e-300, 1.0, 1e300}) {
        for (const double zoom : {1e-300, 1.0, 1e300}) {
            Viewport viewport{.scale = 1, .centre = {-limits::kNumber, 0}, .size = {800, 600}};
            viewport.unitScale = unitScale;
            const QPointF pixel = zoomedTo(viewport, zoom).toPixels({limits::kNumber, limits::kNumber});
            EXPECT_LT(std::abs(pixel.x()), 1e28);
            EXPECT_LT(std::abs(pixel.y()), 1e28);
        }
    }
}

TEST(Viewport, fittingNothingChangesNothingAndFittingOnePointShowsItAt100Percent) {
    const Viewport viewport{.scale = 7, .centre = {5, 5}, .size = {800, 600}, .unitScale = 2};
    EXPECT_EQ(fitted(viewport, Box(), 40), viewport);
    const Viewport onPoint = fitted(viewport, {1, 2, 1, 2}, 40);
    EXPECT_EQ(onPoint.centre, (Point{1, 2}));
    EXPECT_EQ(onPoint.zoom(), 1);
}

TEST(Viewport, revealingMovesNoFurtherThanNeeded) {
    const Viewport viewport{.scale = 1, .centre = {}, .size = {200, 100}};
    EXPECT_EQ(revealing(viewport, {10, 10}, 20), viewport);
    const Viewport moved = revealing(viewport, {1000, 0}, 20);
    EXPECT_EQ(moved.toPixels({1000, 0}), QPointF(180, 50));
}

} // namespace
} // namespace kriva::ui
