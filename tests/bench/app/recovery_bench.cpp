// How long the window's thread is kept while unsaved work is recorded, and what the other thread has to do: a chain of
// knots, cut into curves of 100,000, which is as large as curves are.
#include "app/kept_memory.h"
#include "core/io/json/document_json.h"
#include "ui/document/recovery/document_shadow.h"
#include "ui/document/sharing/content_hash.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>

namespace {

using namespace kriva;
using namespace std::chrono_literals;

constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;

void fill(ui::OpenDocument& document, std::int64_t points) {
    Document value;
    value.active = kSpline;
    while (points > 0) {
        const auto count = static_cast<std::size_t>(std::min<std::int64_t>(points, 100'000));
        Points knots(count);
        for (std::size_t i = 0; i < count; ++i)
            knots[i] = {static_cast<double>(i) / 7, static_cast<double>(i % 13) / 3};
        value.sheets[kSpline].curves.push_back(withPointsAdded(emptyCurve(kSpline), knots));
        points -= static_cast<std::int64_t>(count);
    }
    document.replace(std::move(value));
}

/// What this thread has had of a core.
double threadSeconds() {
    timespec time = {};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The longest turn of the window's thread from the first change on until the snapshot is handed over.
void longestTurnOfTheFirstSnapshot(benchmark::State& state) {
    keepFreedMemory(); // as the editor does
    ui::OpenDocument document;
    fill(document, state.range(0));
    ui::DocumentShadow shadow(document);
    for ([[maybe_unused]] auto _ : state) {
        shadow.drop();
        double longest = 0;
        bool isDone = false;
        while (!isDone) {
            const double start = threadSeconds();
            isDone = shadow.catchUp(4ms);
            if (isDone)
                benchmark::DoNotOptimize(shadow.snapshot());
            longest = std::max(longest, threadSeconds() - start);
        }
        state.SetIterationTime(longest);
    }
}
BENCHMARK(longestTurnOfTheFirstSnapshot)
    ->Arg(1'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// A snapshot while one curve is dragged.
void snapshotAfterOneCurveChanged(benchmark::State& state) {
    ui::OpenDocument document;
    fill(document, state.range(0));
    ui::DocumentShadow shadow(document);
    while (!shadow.catchUp(1h)) {
    }
    const ui::Serial serial = document.serials(kSpline).front();
    for ([[maybe_unused]] auto _ : state) {
        Q_EMIT document.curveChanged(kSpline, serial);
        while (!shadow.catchUp(4ms)) {
        }
        benchmark::DoNotOptimize(shadow.snapshot());
    }
}
BENCHMARK(snapshotAfterOneCurveChanged)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// What the other thread does besides writing.
void bytesOfASnapshot(benchmark::State& state) {
    ui::OpenDocument document;
    fill(document, state.range(0));
    ui::DocumentShadow shadow(document);
    while (!shadow.catchUp(1h)) {
    }
    const ui::DocumentSnapshot snapshot = shadow.snapshot();
    std::size_t bytes = 0;
    for ([[maybe_unused]] auto _ : state) {
        const std::string text = writeDocument(documentOf(snapshot), 0);
        benchmark::DoNotOptimize(ui::contentHash({text.data(), static_cast<qsizetype>(text.size())}));
        bytes = text.size();
    }
    state.counters["MB"] = static_cast<double>(bytes) / 1e6;
}
BENCHMARK(bytesOfASnapshot)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

} // namespace
