#include "tests/bench/app/long_curves.h"
#include "tests/support/test_window.h"

#include <benchmark/benchmark.h>
#include <QMouseEvent>

// What the thread of the window does for one frame of a drag: from a move of the mouse over the new value, the figure
// and all panels to the pixels. Lengths and crossings follow on other threads.
namespace kriva {
namespace {

using namespace test;

void drag(benchmark::State& state, const Curve& curve) {
    test::TestWindow shell;
    ui::SheetTab& tab = shell.shown(curve.index());
    shell.window.document().replace(documentOf(curve));
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
    drag(state, splineThrough(spiral(static_cast<int>(state.range(0))), rule));
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
    drag(state, combinedThrough(spiral(static_cast<int>(state.range(0)))));
}
BENCHMARK(dragInCombined)->RangeMultiplier(10)->Range(10, 10'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace kriva
