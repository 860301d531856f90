#include "core/figure/labels.h"
#include "tests/support/canvas_spline.h"
#include "tests/ui/canvas/canvas_fixture.h"

#include <QImage>
#include <QScreen>
#include <QTest>

#include <cmath>

// A move paints no more than what it changes; what stands on the screen then is what painting everything would give.
namespace kriva::ui {
namespace {

/// A wave of cubics with its polygon, marks and labels, in every kind of pen.
CanvasCurve waveOf(const Points& knots, double width, std::optional<LineDash> dash) {
    CanvasCurve curve = test::splineOf(knots);
    curve.figure.layers[1].strokes[0].style.width = width;
    curve.figure.layers[1].strokes[0].style.dash = dash;
    if (knots.size() < 50)
        curve.figure.layers.push_back({"labels", {}, {}, indexedLabels("K", knots)});
    return curve;
}

struct Case {
    int count;
    double width;
    std::optional<LineDash> dash;
};

class PartialPainting : public ::testing::TestWithParam<Case> {
  protected:
    PartialPainting() {
        input.view = &view;
        view.resize(400, 300);
        view.show();
        for (int i = 0; i < GetParam().count; ++i) {
            const double t = 2.0 * i / (GetParam().count - 1) - 1;
            knots.push_back({t, 0.7 * std::sin(12 * t)});
        }
        view.scene().setCurves({curve()});
        view.setMapping(zoomedTo({.scale = 1, .centre = {}, .size = {400, 300}, .unitScale = 180}, 1));
        QTest::qWait(0);
        QCoreApplication::processEvents();
    }
    CanvasCurve curve() { return waveOf(knots, GetParam().width, GetParam().dash); }
    QImage onScreen() {
        QCoreApplication::processEvents();
        QCoreApplication::processEvents(); // scenes tell their views a turn later
        return view.screen()->grabWindow(view.winId()).toImage().convertToFormat(QImage::Format_RGB32);
    }
    QImage painted() { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

    RecordingInput input;
    CanvasView view{input};
    Points knots;
};

/// Where two pictures differ so that it is seen, empty where they do not. Antialiasing at the edge of what is painted
/// rounds a little otherwise, and a wide line is put together from parts, which may begin elsewhere.
QRect differing(const QImage& a, const QImage& b) {
    constexpr int kSeen = 80; // of 255; a line that was left or forgotten differs by more
    QRect box;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > kSeen)
                box |= QRect(x, y, 1, 1);
    return a.size() == b.size() ? box : a.rect();
}

TEST_P(PartialPainting, ofMovesLeavesWhatPaintingAllGives) {
    EXPECT_EQ(differing(onScreen(), painted()), QRect());
    const QImage before = painted();
    const std::size_t moved = knots.size() / 3;
    view.scene().setSelection({{1, {GripKind::point, static_cast<int>(moved)}}});
    for (int move = 1; move <= 12; ++move) {
        knots[moved] = knots[moved] + Vector{0.013 * move, 0.11 - 0.02 * move};
        view.scene().updateCurve(curve());
        view.scene().setSnap(move % 3 == 0 ? std::optional(Snap{knots[moved], SnapKind::point}) : std::nullopt);
        view.scene().setGhost(move % 4 == 0 ? std::optional(knots[0]) : std::nullopt);
        ASSERT_EQ(differing(onScreen(), painted()), QRect()) << move;
    }
    EXPECT_NE(before, painted());
    view.scene().setSelection({});
    EXPECT_EQ(differing(onScreen(), painted()), QRect());
}

INSTANTIATE_TEST_SUITE_P(OfEveryPen, PartialPainting,
                         ::testing::Values(Case{4, 1, {}}, Case{30, 1.4, {}}, Case{30, 6, {}},
                                           Case{30, 0.5, LineDash::dashed}, Case{30, 3, LineDash::dashDot},
                                           Case{3'000, 1.4, {}}, Case{3'000, 6, LineDash::dotted},
                                           Case{20'000, 1.4, {}}));

} // namespace
} // namespace kriva::ui
