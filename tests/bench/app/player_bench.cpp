#include "tests/support/test_window.h"
#include "ui/controls/player.h"

#include <benchmark/benchmark.h>

// What the thread of the window does for one frame of an animation: from the tick of the player over the stage, its
// figure and all panels to the pixels.
namespace kriva {
namespace {

/// Through 97 elevations of a cubic and back again, with all polygons so far where `hasAllPolygons`.
void playElevations(benchmark::State& state, bool hasAllPolygons) {
    test::TestWindow shell;
    ui::SheetTab& tab = shell.shown(test::kElevation);
    Document document;
    document.sheets[test::kElevation].curves.emplace_back(
        ElevationCurve{"", {{0, 0}, {4, 8}, {12, 8}, {16, 0}}, 0, {}, {}});
    document.sheets[test::kElevation].view.layers["all-polygons"] = hasAllPolygons;
    shell.window.document().replace(std::move(document));
    test::settle();
    ui::Player& player = *tab.findChild<ui::Player*>();
    for (auto _ : state) {
        player.tick();
        QApplication::processEvents();
    }
}
BENCHMARK_CAPTURE(playElevations, polygonOfTheStage, false)->Iterations(97)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(playElevations, allPolygonsSoFar, true)->Iterations(97)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace kriva
