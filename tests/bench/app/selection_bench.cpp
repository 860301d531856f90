#include "app/kept_memory.h"
#include "tests/bench/app/long_curves.h"
#include "tests/support/test_window.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>

// What the thread of the window does for Ctrl+A, and for each of the arrow keys that then move all points: from the key
// over the new value, the figure and all panels to the pixels. The largest of each ten is what a hand waits for.
namespace kriva {
namespace {

using namespace test;

constexpr int kNudges = 10;

[[nodiscard]] double secondsOfThisThread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// With all that follows, to the pixels.
[[nodiscard]] double cost(const std::function<void()>& act) {
    const double start = secondsOfThisThread();
    act();
    QApplication::processEvents();
    return secondsOfThisThread() - start;
}

enum class Key { all, nudge };

void press(benchmark::State& state, const Curve& curve, Key measured) {
    keepFreedMemory(); // as the editor does
    TestWindow shell;
    ui::SheetTab& tab = shell.shown(curve.index());
    shell.window.document().replace(documentOf(curve));
    settle();
    QTest::mouseMove(tab.canvas().viewport(),
                     tab.canvas().viewport()->rect().center()); // what is under it is told anew
    double largest = 0;
    const auto tell = [&](double seconds) {
        largest = std::max(largest, seconds);
        state.SetIterationTime(seconds);
    };
    const auto selectAll = [&] { QTest::keyClick(&tab.canvas(), Qt::Key_A, Qt::ControlModifier); };
    if (measured == Key::nudge)
        (void)cost(selectAll);
    for (auto _ : state) {
        if (measured == Key::nudge) {
            tell(cost([&] { QTest::keyClick(&tab.canvas(), Qt::Key_Right); }));
        } else {
            (void)cost([&] { tab.editor().selectNone(); });
            tell(cost(selectAll));
        }
    }
    if (tab.editor().selectedPoints().size() != pointCount(curve))
        state.SkipWithError("not all points are selected");
    state.counters["largest_ms"] = 1000 * largest;
    settle();
}

void inSpline(benchmark::State& state, SplineCurve::Rule rule, Key key) {
    press(state, splineThrough(spiral(static_cast<int>(state.range(0))), rule), key);
}
void inCombined(benchmark::State& state, Key key) {
    press(state, combinedThrough(spiral(static_cast<int>(state.range(0)))), key);
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->Arg(1'000)->Arg(10'000)->Arg(100'000)->Iterations(kNudges)->UseManualTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(inSpline, mirrorAll, SplineCurve::Rule::mirror, Key::all)->Apply(sizes);
BENCHMARK_CAPTURE(inSpline, mirrorNudge, SplineCurve::Rule::mirror, Key::nudge)->Apply(sizes);
BENCHMARK_CAPTURE(inSpline, naturalNudge, SplineCurve::Rule::natural, Key::nudge)->Apply(sizes);
BENCHMARK_CAPTURE(inSpline, catmullRomNudge, SplineCurve::Rule::catmullRom, Key::nudge)->Apply(sizes);
BENCHMARK_CAPTURE(inCombined, combinedAll, Key::all)->Apply(sizes);
BENCHMARK_CAPTURE(inCombined, combinedNudge, Key::nudge)->Apply(sizes);

} // namespace
} // namespace kriva
