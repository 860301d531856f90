// A path of 100,000 cubics as an SVG file and back: as Kriva writes it, exactly and with three decimals, beside Qt's
// own generator.

#include "core/io/svg/paths/svg_paths.h"
#include "core/io/svg/svg_writer.h"
#include "tests/support/data_sets.h"

#include <benchmark/benchmark.h>
#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>

namespace {

using namespace kriva;

constexpr std::size_t kCubics = 100'000;

const Path& walk() {
    static const Path path = chain(test::catmullRom(test::randomWalk(kCubics + 1)), false);
    return path;
}

const TextSource kTexts{[](Caption) { return std::string(); }, [](double, int) { return std::string(); }, "en"};

std::string written(std::optional<int> decimals) {
    static const Drawing drawing = [] {
        Drawing made;
        made.figure.layers = {{"curve", {{walk(), Role::curve}}}};
        made.page = pageOf(boxOf(walk().points), 1);
        return made;
    }();
    return writeSvg(drawing, kTexts, {{}, decimals, false});
}

void write(benchmark::State& state, std::optional<int> decimals) {
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = written(decimals).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}

void writeByQt(benchmark::State& state) {
    QPainterPath path;
    forEachPiece(walk(), [&](std::span<const Point> p) {
        if (path.elementCount() == 0)
            path.moveTo(p[0].x, p[0].y);
        path.cubicTo(p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y);
    });
    QByteArray bytes;
    for (auto _ : state) {
        bytes.clear();
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize({1000, 1000});
        QPainter painter(&generator);
        painter.drawPath(path);
    }
    state.counters["bytes"] = static_cast<double>(bytes.size());
}

void read(benchmark::State& state, std::optional<int> decimals) {
    const std::string svg = written(decimals);
    std::size_t pieces = 0;
    for (auto _ : state)
        pieces = std::get<std::vector<ImportedPath>>(readSvgPaths(svg)).front().path.degrees.size();
    if (pieces != kCubics)
        state.SkipWithError("pieces are missing");
}

BENCHMARK_CAPTURE(write, exact, std::nullopt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(write, threeDecimals, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(writeByQt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, exact, std::nullopt)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, threeDecimals, 3)->Unit(benchmark::kMillisecond);

} // namespace
