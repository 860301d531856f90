// How long it takes to find all crossings of a spline, and how many there are: with segments that run through the whole
// sheet, where the crossings grow with the square of the points, and with segments that stay near each other.

#include "core/intersections/crossings.h"
#include "tests/support/data_sets.h"

#include <benchmark/benchmark.h>

namespace {

void findAll(benchmark::State& state, const kriva::Points& points) {
    const std::vector<kriva::Points> spline = kriva::test::catmullRom(points);
    const kriva::SegmentChain chain{spline, false};
    std::size_t places = 0;
    for (auto _ : state)
        places = kriva::findCrossings({&chain, 1}).places.size();
    state.counters["crossings"] = static_cast<double>(places);
}

void global(benchmark::State& state) {
    findAll(state, kriva::test::randomPoints(46, static_cast<std::size_t>(state.range(0))));
}

void local(benchmark::State& state) {
    findAll(state, kriva::test::randomWalk(static_cast<std::size_t>(state.range(0))));
}

BENCHMARK(global)->RangeMultiplier(10)->Range(10, 1000)->Unit(benchmark::kMillisecond);
BENCHMARK(local)->RangeMultiplier(10)->Range(10, 10'000)->Unit(benchmark::kMillisecond);

} // namespace
