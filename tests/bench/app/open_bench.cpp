#include "tests/support/test_window.h"

#include <benchmark/benchmark.h>
#include <QElapsedTimer>
#include <QMouseEvent>

#include <algorithm>
#include <memory>
#include <random>

// How long a person waits while the crossings of a large document are worked out: for its first picture, for the
// slowest of 50 frames of a drag, and for the window to close. Wall time, since waiting is what is asked about.
namespace kriva {
namespace {

constexpr int kFrames = 50;

Document randomSplines(int curves, int knots) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0, 100);
    Document document;
    document.active = test::kSpline;
    for (int i = 0; i < curves; ++i) {
        SplineCurve curve;
        for (int k = 0; k < knots; ++k)
            curve.knots.push_back({{anywhere(random), anywhere(random)}, {}, {}, {}});
        document.sheets[test::kSpline].curves.emplace_back(std::move(curve));
    }
    return document;
}

double milliseconds(const QElapsedTimer& clock) {
    return static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

double slowestFrame(ui::SheetTab& tab) {
    QWidget* canvas = tab.canvas().viewport();
    const QPoint start = test::pixelOf(tab, 1);
    QTest::mousePress(canvas, Qt::LeftButton, {}, start);
    double slowest = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
        QElapsedTimer clock;
        clock.start();
        const QPoint to = start + QPoint(10 + frame, frame);
        QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(QPointF(to)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(canvas, &move);
        QApplication::processEvents();
        slowest = std::max(slowest, milliseconds(clock));
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, start);
    return slowest;
}

void open(benchmark::State& state) {
    const Document document = randomSplines(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    for (auto _ : state) {
        auto shell = std::make_unique<test::TestWindow>();
        ui::SheetTab& tab = shell->shown(2);
        QElapsedTimer clock;
        clock.start();
        shell->window.session().show(document);
        QApplication::processEvents();
        state.counters["first_paint_ms"] = milliseconds(clock);
        state.counters["slowest_frame_ms"] = slowestFrame(tab);
        clock.start();
        shell.reset();
        state.counters["close_ms"] = milliseconds(clock);
    }
}
BENCHMARK(open)
    ->ArgNames({"curves", "knots"})
    ->Args({1, 1'000})
    ->Args({1, 2'000})
    ->Args({1'000, 4})
    ->Args({1, 20'001})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace kriva
