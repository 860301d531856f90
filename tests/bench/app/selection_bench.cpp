#include "app/kept_memory.h"
#include "tests/bench/app/long_curves.h"
#include "tests/support/test_window.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>

// What the thread of the window does for Ctrl+A, and for each of the arrow keys that then move all points: from the key
// over the new value, the figure and all panels to the pixels. The longest turn of each ten keys is what a hand waits
// for.
namespace kriva {
namespace {

using namespace test;

constexpr int kNudges = 10;

[[nodiscard]] double secondsOfThisThread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Seconds of the thread of the window, with all that follows a key: what is drawn and worked out beside the window
/// arrives in turns of its own, between which a hand is served.
struct Cost {
    double longestTurn = 0;
    double all = 0;
};

[[nodiscard]] Cost cost(ui::MainWindow& window, const std::function<void()>& act) {
    Cost cost;
    const auto turn = [&](const std::function<void()>& work) {
        const double start = secondsOfThisThread();
        work();
        QApplication::processEvents();
        const double taken = secondsOfThisThread() - start;
        cost.all += taken;
        cost.longestTurn = std::max(cost.longestTurn, taken);
    };
    turn(act);
    const auto none = [] {};
    while (!window.workers().waitForDone(1))
        turn(none);
    for (int i = 0; i < 3; ++i)
        turn(none);
    return cost;
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
    Cost largest;
    const auto tell = [&](const Cost& now) {
        largest = {std::max(largest.longestTurn, now.longestTurn), std::max(largest.all, now.all)};
        state.SetIterationTime(now.longestTurn);
    };
    const auto selectAll = [&] { QTest::keyClick(&tab.canvas(), Qt::Key_A, Qt::ControlModifier); };
    if (measured == Key::nudge)
        (void)cost(shell.window, selectAll);
    for (auto _ : state) {
        if (measured == Key::nudge) {
            tell(cost(shell.window, [&] { QTest::keyClick(&tab.canvas(), Qt::Key_Right); }));
        } else {
            (void)cost(shell.window, [&] { tab.editor().selectNone(); });
            tell(cost(shell.window, selectAll));
        }
    }
    if (tab.editor().selectedPoints().size() != pointCount(curve))
        state.SkipWithError("not all points are selected");
    state.counters["longest_turn_ms"] = 1000 * largest.longestTurn;
    state.counters["all_turns_ms"] = 1000 * largest.all;
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
