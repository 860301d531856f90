#include "core/figure/role_style.h"
#include "tests/ui/canvas/canvas_fixture.h"

namespace kriva::ui {
namespace {

/// A point just below the x axis, whose label would stand on it.
class LabelsOnCanvas : public CanvasTest {
  protected:
    LabelsOnCanvas() {
        CanvasCurve curve{1, {{{"labels", {}, {}, {Label{{40, -8}, Caption::none, "WWW", ""}}}}}, {}, true};
        view.scene().setCurves({curve});
        view.scene().setGridShown(false);
    }
    /// Dark pixels above the x axis, where the label would stand.
    [[nodiscard]] int inkAboveTheAxis() {
        const QImage picture = view.grab().toImage();
        int count = 0;
        for (int y = 180; y < 199; ++y)
            for (int x = 235; x < 300; ++x)
                count += picture.pixelColor(x, y).lightness() < 150 ? 1 : 0;
        return count;
    }
};

TEST_F(LabelsOnCanvas, keepOffTheAxesWhereThereIsRoom) {
    view.scene().setAxesShown(false);
    EXPECT_GT(inkAboveTheAxis(), 0);
    view.scene().setAxesShown(true);
    EXPECT_EQ(inkAboveTheAxis(), 0);
}

} // namespace
} // namespace kriva::ui
