#include "core/bezier/evaluate.h"
#include "core/bezier/nearest.h"
#include "tests/support/long_run.h"
#include "tests/ui/canvas/canvas_fixture.h"
#include "ui/canvas/base/qt_geometry.h"

#include <QImage>

#include <cmath>

// Where the pixels themselves are: QPainter's own cubics go astray at high zoom.
namespace kriva::ui {
namespace {

constexpr double kAllowed = 0.75; ///< pixels between the ink's middle line and the exact curve

struct InkCase {
    const char* name;
    Points curve;
    double t; ///< what is looked at
};

std::ostream& operator<<(std::ostream& out, const InkCase& one) {
    return out << one.name;
}

class Ink : public testing::TestWithParam<InkCase> {
  protected:
    Ink() {
        view.resize(600, 400);
        view.scene().setGridShown(false);
        view.scene().setAxesShown(false);
        CanvasCurve curve;
        curve.serial = 1;
        curve.figure = {{{"curve", {{.path = singleCurve(GetParam().curve)}}}}};
        view.scene().setCurves({std::move(curve)});
    }
    /// The curve around t, so many pixels to a unit.
    QImage shown(double scale, double ratio) {
        QImage image(view.size() * ratio, QImage::Format_RGB32);
        image.setDevicePixelRatio(ratio);
        view.setMapping({.scale = scale,
                         .centre = evaluate(GetParam().curve, GetParam().t),
                         .size = QSizeF(view.viewport()->size()),
                         .unitScale = 100});
        view.QWidget::render(&image);
        return image;
    }
    /// Of a pixel's middle from the exact curve, in pixels of the view.
    double distanceFromCurve(QPointF pixel) const {
        return nearest(GetParam().curve, view.mapping().toDocument(pixel)).distance * view.mapping().scale;
    }

    RecordingInput input;
    CanvasView view{input};
    const double halfPen = styleOf(Role::curve, 0, Theme::light).width * kPixelsPerPoint / 2;
};

TEST_P(Ink, isOnTheCurveAtEveryZoom) {
    const int each = test::isLongRun() ? 1 : 7; // of the pixels is looked at: a degree of 30 takes long
    for (const double scale : {1e2, 1e3, 1e4, 1e5, 1e6, 1e8}) {
        const QImage image = shown(scale, 1);
        const QColor paper = view.palette().color(QPalette::Base);
        int inked = 0;
        double farthest = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (std::abs(image.pixelColor(x, y).red() - paper.red()) > 100) // more than half covered
                    if (++inked % each == 0)
                        farthest = std::max(farthest, distanceFromCurve({x + 0.5, y + 0.5}));
        EXPECT_GT(inked, 100) << scale; // never blank
        EXPECT_LE(farthest, halfPen + kAllowed) << scale;
    }
}

TEST_P(Ink, coversTheCurveAtEveryZoomAndPixelRatio) {
    for (const double ratio : {1.0, 1.5, 2.0})
        for (const double scale : {1e2, 1e4, 1e6}) {
            const QImage image = shown(scale, ratio);
            const QColor paper = view.palette().color(QPalette::Base);
            for (int i = -100; i <= 100; ++i) {
                const double t = GetParam().t + i / scale;
                const QPointF pixel = view.mapping().toPixels(evaluate(GetParam().curve, t)) * ratio;
                const QPoint at(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
                if (t < 0 || t > 1 || !image.rect().contains(at))
                    continue;
                EXPECT_GT(std::abs(image.pixelColor(at).red() - paper.red()), 60) << scale << ' ' << ratio << ' ' << t;
            }
        }
}

Points wild() {
    Points points;
    for (int i = 0; i <= 30; ++i)
        points.push_back({3 * std::sin(2.0 * i), 2 * std::cos(5.0 * i)});
    return points;
}

INSTANTIATE_TEST_SUITE_P(Curves, Ink,
                         testing::Values(InkCase{"cubic", {{0, 0}, {0, 2}, {8, 2}, {4, 0}}, 0.37},
                                         InkCase{"loop", {{0, 0}, {6, 4}, {-2, 4}, {4, 0}}, 0.5},
                                         InkCase{"line", {{-1, -2}, {3, 1}}, 0.62},
                                         InkCase{"cusp", {{0, 0}, {2, 2}, {0, 2}, {2, 0}}, 0.5},
                                         InkCase{"degree30", wild(), 0.21}),
                         [](const auto& one) { return std::string(one.param.name); });

} // namespace
} // namespace kriva::ui
