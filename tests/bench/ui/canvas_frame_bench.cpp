#include "tests/support/canvas_spline.h"
#include "ui/canvas/base/qt_geometry.h"
#include "ui/canvas/canvas_view.h"

#include <benchmark/benchmark.h>
#include <QApplication>
#include <QImage>

#include <cmath>
#include <random>

// How long one frame of the canvas takes, from a new value to the pixels, at 1000 x 1000 on the raster engine.
namespace kriva::ui {
namespace {

class NoInput : public CanvasInput {
  public:
    void hover(const PointerEvent&) override {}
    void click(const PointerEvent&) override {}
    bool doubleClick(const PointerEvent&) override { return true; }
    bool beginDrag(const PointerEvent&) override { return true; }
    void drag(Vector, const DragKeys&) override {}
    void endDrag() override {}
    void cancelDrag() override {}
    void select(Selection) override {}
    void nudge(Vector) override {}
    void removeSelected(Removal) override {}
    void insertPoint(std::optional<CurvePlace>) override {}
};

/// A wave that fills the square from -1 to 1.
Points wave(int count) {
    Points points;
    for (int i = 0; i < count; ++i) {
        const double t = 2.0 * i / (count - 1) - 1;
        points.push_back({t, 0.9 * std::sin(40 * t) * std::cos(3 * t)});
    }
    return points;
}
/// Points all over the square, each far from the one before: the most ink there can be.
Points scribble(int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back({anywhere(random), anywhere(random)});
    return points;
}

class Canvas {
  public:
    Canvas() { view_.resize(1000, 1000); }

    CanvasScene& scene() { return view_.scene(); }
    void paint() { view_.QWidget::render(&image_); }
    void look(double zoom, Point centre = {}) {
        view_.setMapping(zoomedTo({.scale = 1, .centre = centre, .size = {1000, 1000}, .unitScale = 480}, zoom));
    }

  private:
    NoInput input_;
    CanvasView view_{input_};
    QImage image_{1000, 1000, QImage::Format_RGB32};
};

void dragFrame(benchmark::State& state) {
    Canvas canvas;
    Points knots = wave(static_cast<int>(state.range(0)));
    canvas.scene().setCurves({test::splineOf(knots)});
    canvas.look(1);
    for (auto _ : state) {
        knots[knots.size() / 2].y += 1e-3;
        canvas.scene().updateCurve(test::splineOf(knots));
        canvas.paint();
    }
}
BENCHMARK(dragFrame)->Arg(4)->Arg(100)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void panFrame(benchmark::State& state, Points (*points)(int)) {
    Canvas canvas;
    canvas.scene().setCurves({test::splineOf(points(static_cast<int>(state.range(0))))});
    double x = 0;
    for (auto _ : state) {
        canvas.look(static_cast<double>(state.range(1)), {x += 1e-3 / static_cast<double>(state.range(1)), 0.1});
        canvas.paint();
    }
}
BENCHMARK_CAPTURE(panFrame, wave, wave)->ArgsProduct({{1'000, 100'000}, {1, 10, 1'000}})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(panFrame, scribble, scribble)
    ->ArgsProduct({{1'000, 10'000, 100'000}, {1, 10, 1'000}})
    ->Unit(benchmark::kMillisecond);

void zoomFrame(benchmark::State& state, double zoom) {
    Canvas canvas;
    canvas.scene().setCurves({test::splineOf(scribble(10'000))});
    double x = 0;
    for (auto _ : state) {
        canvas.look(zoom, {x += 1e-3 / zoom, 0.1});
        canvas.paint();
    }
}
BENCHMARK_CAPTURE(zoomFrame, 1e-6, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(zoomFrame, 1e-3, 1e-3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(zoomFrame, 0.1, 0.1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(zoomFrame, 1e3, 1e3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(zoomFrame, 1e6, 1e6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(zoomFrame, 1e9, 1e9)->Unit(benchmark::kMillisecond);

void penFrame(benchmark::State& state, Points (*points)(int)) {
    Canvas canvas;
    CanvasCurve curve = test::splineOf(points(static_cast<int>(state.range(0))));
    const double width = static_cast<double>(state.range(1)) / kPixelsPerPoint;
    for (Layer& layer : curve.figure.layers)
        for (Stroke& stroke : layer.strokes)
            stroke.style.width = width;
    canvas.scene().setCurves({std::move(curve)});
    double x = 0;
    for (auto _ : state) {
        canvas.look(1, {x += 1e-3, 0.1});
        canvas.paint();
    }
}
BENCHMARK_CAPTURE(penFrame, wave, wave)->ArgsProduct({{100, 10'000}, {1, 4, 20}})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(penFrame, scribble, scribble)
    ->ArgsProduct({{100, 10'000}, {1, 4, 20}})
    ->Unit(benchmark::kMillisecond);

void manyCurves(benchmark::State& state) {
    Canvas canvas;
    std::vector<CanvasCurve> curves;
    for (int i = 0; i < 1'000; ++i) {
        Points points = wave(static_cast<int>(state.range(0)));
        for (Point& p : points)
            p.y = p.y / 10 + i / 500.0 - 1;
        curves.push_back(test::splineOf(points, static_cast<Serial>(i) + 1));
    }
    canvas.scene().setCurves(std::move(curves));
    double x = 0;
    for (auto _ : state) {
        canvas.look(1, {x += 1e-3, 0});
        canvas.paint();
    }
}
BENCHMARK(manyCurves)->Arg(10)->Arg(1'000)->Unit(benchmark::kMillisecond);

void highDegree(benchmark::State& state) {
    Canvas canvas;
    const Points points = scribble(static_cast<int>(state.range(0)) + 1);
    double x = 0;
    canvas.scene().setCurves({{1, {{{"curve", {{.path = singleCurve(points)}}}}}, {}, true}});
    for (auto _ : state) {
        canvas.look(static_cast<double>(state.range(1)), {x += 1e-3 / static_cast<double>(state.range(1)), 0});
        canvas.paint();
    }
}
BENCHMARK(highDegree)->ArgsProduct({{3, 30, 200}, {1, 1'000, 1'000'000}})->Unit(benchmark::kMillisecond);

void hover(benchmark::State& state) {
    Canvas canvas;
    canvas.scene().setCurves({test::splineOf(wave(static_cast<int>(state.range(0))))});
    canvas.look(1);
    canvas.paint();
    double x = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(canvas.scene().hitAt({x += 0.1, 500}));
}
BENCHMARK(hover)->Arg(1'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace kriva::ui
