#include "tests/support/test_window.h"

#include <benchmark/benchmark.h>
#include <QMouseEvent>

#include <cmath>

// What the thread of the window does for one frame of a drag: from a move of the mouse over the new value, the figure
// and all panels to the pixels. Lengths and crossings follow on other threads.
namespace kriva {
namespace {

/// A spiral with waves on it: long, and crossing itself now and then.
Points spiral(int count) {
    Points points;
    for (int i = 0; i < count; ++i) {
        const double t = i / 20.0;
        const double radius = 10 + t + 3 * std::sin(7 * t);
        points.push_back({radius * std::cos(t), radius * std::sin(t)});
    }
    return points;
}

Curve splineThrough(const Points& points, SplineCurve::Rule rule) {
    SplineCurve curve;
    curve.rule = rule;
    for (const Point at : points)
        curve.knots.push_back({at, {}, {}, {}});
    return curve;
}

Curve combinedThrough(const Points& points) {
    CombinedCurve curve;
    curve.points = points;
    return curve;
}

void drag(benchmark::State& state, SheetIndex sheet, const Curve& curve) {
    test::TestWindow shell;
    ui::SheetTab& tab = shell.shown(sheet);
    Document document;
    document.active = sheet;
    document.sheets[sheet].curves = {curve};
    shell.window.document().replace(std::move(document));
    test::settle();
    QWidget* canvas = tab.canvas().viewport();
    const QPoint start = test::pixelOf(tab, static_cast<int>(pointCount(curve)) / 2);
    QTest::mousePress(canvas, Qt::LeftButton, {}, start);
    int moves = 0;
    for (auto _ : state) {
        const QPoint to = start + QPoint(10 + moves % 40, moves % 30);
        ++moves;
        QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(QPointF(to)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(canvas, &move);
        QApplication::processEvents();
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, start);
    test::settle();
}

void dragInSpline(benchmark::State& state, SplineCurve::Rule rule) {
    drag(state, 2, splineThrough(spiral(static_cast<int>(state.range(0))), rule));
}
BENCHMARK_CAPTURE(dragInSpline, mirror, SplineCurve::Rule::mirror)
    ->RangeMultiplier(10)
    ->Range(10, 10'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dragInSpline, natural, SplineCurve::Rule::natural)
    ->RangeMultiplier(10)
    ->Range(10, 10'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(dragInSpline, catmullRom, SplineCurve::Rule::catmullRom)
    ->RangeMultiplier(10)
    ->Range(10, 10'000)
    ->Unit(benchmark::kMillisecond);

void dragInCombined(benchmark::State& state) {
    drag(state, 3, combinedThrough(spiral(static_cast<int>(state.range(0)))));
}
BENCHMARK(dragInCombined)->RangeMultiplier(10)->Range(10, 10'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace kriva
