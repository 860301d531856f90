#include "core/bezier/evaluate.h"
#include "core/geometry/segment.h"
#include "tests/ui/canvas/canvas_fixture.h"

#include <QImage>
#include <QSignalSpy>

#include <cmath>

namespace kriva::ui {
namespace {

const Points kCurve{{-3, 1}, {9, 7.3}, {-6.1, 8}, {2.2, -5}};

/// A canvas of 300 x 300 pixels without grid and axes.
class Canvas : public ::testing::Test {
  protected:
    Canvas()
        : view(input) {
        input.view = &view;
        QPalette paper;
        paper.setColor(QPalette::Base, Qt::white);
        paper.setColor(QPalette::Text, Qt::black);
        view.setPalette(paper);
        view.resize(300, 300);
        view.scene().setGridShown(false);
        view.scene().setAxesShown(false);
        show(kCurve);
    }
    void show(const Points& curve) {
        view.scene().setCurves({{1, {{{"curve", {{.path = singleCurve(curve)}}}}}, {}, true}});
    }
    /// Around the curve's point at t.
    void lookAt(double t, double zoom) {
        view.setMapping(
            zoomedTo({.scale = 1, .centre = evaluate(kCurve, t), .size = {300, 300}, .unitScale = 25}, zoom));
    }
    QImage rendered(double devicePixelRatio = 1) {
        QImage image(QSize(300, 300) * devicePixelRatio, QImage::Format_RGB32);
        image.setDevicePixelRatio(devicePixelRatio);
        image.fill(Qt::white);
        view.QWidget::render(&image);
        return image;
    }
    /// The pixels that are nearer to the curve's colour than to the paper's, in logical pixels.
    static std::vector<Point> inked(const QImage& image) {
        std::vector<Point> pixels;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (qRed(image.pixel(x, y)) < 128) // the curve's blue has no red
                    pixels.push_back({(x + 0.5) / image.devicePixelRatio(), (y + 0.5) / image.devicePixelRatio()});
        return pixels;
    }
    /// The curve in and around what is seen.
    QPolygonF exact(double t, double zoom) const {
        QPolygonF pixels;
        for (int i = -1'500; i <= 1'500; ++i) {
            const double at = t + i / 1.5e3 / zoom;
            const QPointF pixel = view.mapping().toPixels(evaluate(kCurve, at));
            if (at >= 0 && at <= 1 && QRectF(-50, -50, 400, 400).contains(pixel))
                pixels.append(pixel);
        }
        return pixels;
    }
    static double distanceToLine(Point p, const QPolygonF& line) {
        double nearest = 1e9;
        for (qsizetype i = 1; i < line.size(); ++i)
            nearest =
                std::min(nearest, distanceToSegment(p, {line[i - 1].x(), line[i - 1].y()}, {line[i].x(), line[i].y()}));
        return nearest;
    }
    static double distanceToAny(QPointF p, const std::vector<Point>& points) {
        double nearest = 1e9;
        for (const Point q : points)
            nearest = std::min(nearest, distance({p.x(), p.y()}, q));
        return nearest;
    }

    RecordingInput input;
    CanvasView view;
};

TEST_F(Canvas, inkLiesWithinThreeQuartersOfAPixelOfTheExactCurve) {
    const double halfWidth = styleOf(Role::curve, 0, Theme::light).width * 96 / 72 / 2;
    for (const double zoom : {1.0, 16.0, 256.0, 1e4, 1e6}) {
        for (const double t : {0.2, 0.61}) {
            for (const double ratio : {1.0, 1.5, 2.0}) {
                lookAt(t, zoom);
                const QPolygonF curve = exact(t, zoom);
                const std::vector<Point> ink = inked(rendered(ratio));
                ASSERT_GT(curve.size(), 100);
                ASSERT_GT(ink.size(), 100U);
                for (std::size_t i = 0; i < ink.size(); i += 7)
                    ASSERT_LE(distanceToLine(ink[i], curve), halfWidth + 0.75) << zoom << " at ratio " << ratio;
                for (qsizetype i = 0; i < curve.size(); i += 7) {
                    if (!QRectF(0, 0, 300, 300).contains(curve[i]))
                        continue;
                    ASSERT_LE(distanceToAny(curve[i], ink), 0.75) << zoom << " at ratio " << ratio;
                }
            }
        }
    }
}

TEST_F(Canvas, aCurveOfManyPointsIsDrawnToItsEndInOneColour) {
    Points circle;
    for (int i = 0; i <= 5'000; ++i)
        circle.push_back({100 * std::cos(i * 1e-3), 100 * std::sin(i * 1e-3)});
    view.scene().setCurves({{1, {{{"curve", {{.path = polyline(circle)}}}}}, {}, true}});
    view.setMapping({.scale = 1, .centre = {}, .size = {300, 300}});
    const QImage image = rendered();
    for (int i = 20; i < 4'980; i += 7) { // its ends are cut off flat
        const QPoint pixel(static_cast<int>(150 + circle[static_cast<std::size_t>(i)].x),
                           static_cast<int>(150 - circle[static_cast<std::size_t>(i)].y));
        ASSERT_LT(qRed(image.pixel(pixel)), 160) << "a gap at " << i;
    }
}

TEST_F(Canvas, marksStandOnTheirPointsWithTheSameSizeAtEveryZoom) {
    view.scene().setCurves({{1, {{{"points", {}, {{{{0, 0}}, Role::curvePoint}}}}}, {}, true}});
    for (const double zoom : {1e-3, 1.0, 1e5}) {
        view.setMapping(zoomedTo({.scale = 1, .centre = {0, 0}, .size = {300, 300}, .unitScale = 25}, zoom));
        QRect mark;
        const QImage image = rendered();
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 300; ++x)
                if (image.pixel(x, y) != qRgb(255, 255, 255))
                    mark |= QRect(x, y, 1, 1);
        EXPECT_LE((QRectF(mark).center() - QPointF(150, 150)).manhattanLength(), 1.5);
        EXPECT_NEAR(mark.width(), styleOf(Role::curvePoint, 0, Theme::light).markerSize * 96 / 72, 2.1);
    }
}

TEST_F(Canvas, updatingACurveChangesWhatIsDrawn) {
    lookAt(0.5, 1);
    const QImage before = rendered();
    view.scene().updateCurve({1, {{{"curve", {{.path = singleCurve(Points{{-3, 0}, {3, 1}})}}}}}, {}, true});
    EXPECT_NE(rendered(), before);
    view.scene().updateCurve({1, {{{"curve", {{.path = singleCurve(kCurve)}}}}}, {}, true});
    EXPECT_EQ(rendered(), before);
}

TEST_F(Canvas, selectedAndHoveredGripsLookDifferent) {
    CanvasCurve curve{1, {}, {{{GripKind::point, 0, 0}, {0, 0}}}, true};
    view.scene().setCurves({curve});
    view.setMapping({.scale = 1, .centre = {}, .size = {300, 300}});
    const QImage normal = rendered();
    view.scene().setSelection({{1, {GripKind::point, 0, 0}}});
    const QImage selected = rendered();
    view.scene().setSelection({});
    QMouseEvent move(QEvent::MouseMove, {150, 150}, {150, 150}, Qt::NoButton, {}, {});
    QApplication::sendEvent(view.viewport(), &move);
    const QImage hovered = rendered();
    EXPECT_NE(normal, selected);
    EXPECT_NE(normal, hovered);
    EXPECT_NE(selected, hovered);
}

TEST_F(Canvas, gridAndAxesAreShownWhenAsked) {
    view.scene().setCurves({});
    view.setMapping({.scale = 1, .centre = {30, 40}, .size = {300, 300}});
    const QImage empty = rendered();
    view.scene().setGridShown(true);
    const QImage grid = rendered();
    view.scene().setAxesShown(true);
    EXPECT_NE(grid, empty);
    EXPECT_NE(rendered(), grid);
}

TEST_F(Canvas, numbersOfTheAxesFollowTheLanguage) {
    view.scene().setAxesShown(true);
    view.setMapping({.scale = 200, .centre = {}, .size = {300, 300}}); // numbers with decimals
    const QImage english = rendered();
    QLocale::setDefault(QLocale(QLocale::Slovenian));
    QEvent change(QEvent::LanguageChange);
    QApplication::sendEvent(&view, &change);
    const QImage slovenian = rendered();
    QLocale::setDefault(QLocale(QLocale::English));
    EXPECT_NE(slovenian, english);
}

TEST_F(Canvas, manyLabelsAreLeftOut) {
    const auto labelled = [this](int count) {
        Layer layer{"labels"};
        for (int i = 0; i < count; ++i)
            layer.labels.push_back({{i % 20 * 10.0, i / 20 * 10.0}, Caption::none, "b", {}});
        view.scene().setCurves({{1, {{layer}}, {}, true}});
        view.setMapping({.scale = 1, .centre = {100, 100}, .size = {300, 300}});
        return rendered();
    };
    const QImage few = labelled(10);
    const QImage many = labelled(201);
    view.scene().setCurves({});
    EXPECT_NE(few, rendered());
    EXPECT_EQ(many, rendered());
}

TEST_F(Canvas, crowdedFiguresAreDrawnWithFewerPoints) {
    Points scribble;
    for (int i = 0; i < 100'000; ++i)
        scribble.push_back({100 * std::sin(i * 0.001), 100 * std::cos(i * 0.0013)});
    view.scene().setCurves({{1, {{{"curve", {{.path = polyline(scribble)}}}}}, {}, true}});
    view.setMapping({.scale = 1, .centre = {}, .size = {300, 300}});
    EXPECT_FALSE(inked(rendered()).empty());
}

TEST_F(Canvas, marksOfManyCurvesTakeNoRoomFromTheirLines) {
    constexpr int kCurves = 1'000;
    constexpr int kPoints = 40;
    std::vector<CanvasCurve> curves;
    for (int i = 0; i < kCurves; ++i) {
        Points points;
        for (int k = 0; k < kPoints; ++k)
            points.push_back({100 * std::sin(1.7 * k + i), 100 * std::cos(2.9 * k + 3 * i)});
        const Figure figure{{{"curve", {{.path = polyline(points), .role = Role::curve}}},
                             {"handles", {}, {{points, Role::handle}}},
                             {"knots", {}, {{points, Role::knot}}}}};
        curves.push_back({static_cast<Serial>(i + 1), figure, {}, false});
    }
    const auto linesOf = [&] {
        view.scene().setCurves(curves);
        view.setMapping({.scale = 1, .centre = {}, .size = {300, 300}});
        rendered();
        qsizetype lines = 0;
        for (const HitTarget& target : view.scene().curves().targets())
            for (const QPolygonF& polyline : target.lines)
                lines += polyline.size() - 1;
        return lines;
    };
    const qsizetype withMarks = linesOf();
    for (CanvasCurve& curve : curves)
        curve.figure.layers.resize(1);
    EXPECT_GT(withMarks, 1'000);
    EXPECT_GE(2 * withMarks, linesOf());
}

TEST_F(Canvas, zoomIsTheScaleOfThePageAt96Dpi) {
    QSignalSpy zooms(&view, &CanvasView::zoomChanged);
    view.setUnitScale(50);
    view.zoomTo100();
    EXPECT_EQ(view.zoomPercent(), 100);
    EXPECT_EQ(view.mapping().scale, 50);
    view.zoomIn();
    EXPECT_EQ(view.zoomPercent(), 125);
    view.zoomOut();
    EXPECT_EQ(view.zoomPercent(), 100);
    EXPECT_GE(zooms.size(), 3);
}

TEST_F(Canvas, aFitFollowsTheSizeUntilAPersonDoesSomething) {
    view.fitAll();
    view.resize(500, 200);
    view.show();
    view.grab();
    const Box box = boxOf(kCurve);
    const auto left = [&] { return view.mapping().toPixels({box.xmin, box.ymax}).x(); };
    const auto top = [&] { return view.mapping().toPixels({box.xmin, box.ymax}).y(); };
    EXPECT_GE(top(), 0);
    EXPECT_LE(top(), 41);
    view.resize(120, 200); // panels took their room
    EXPECT_GE(left(), 0);
    EXPECT_LE(left(), 41);
    view.resize(500, 200);
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, {2, 2});
    const double before = top();
    view.resize(800, 200);
    EXPECT_EQ(top(), before) << "from now on sizes only show more";
}

TEST_F(Canvas, whatIsInTheMiddleStaysThereWhenTheSizeChanges) {
    view.show();
    view.grab();
    lookAt(0.3, 2);
    const Point centre = view.mapping().centre;
    view.resize(500, 400);
    EXPECT_EQ(view.mapping().centre, centre);
    EXPECT_EQ(view.mapping().size, QSizeF(view.viewport()->size()));
}

} // namespace
} // namespace kriva::ui
