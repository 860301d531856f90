#include "core/document/sheet_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

/// Three curves of a kind, one of them hidden and one in a style of its own.
class FigureOfSheet : public testing::TestWithParam<SheetIndex> {
  protected:
    FigureOfSheet() {
        const Points points{{0, 0}, {1, 2}, {3, 2}, {2, 0}};
        sheet.curves.assign(3, withPointsAdded(emptyCurve(index), points));
        sheet.curves[0] = withView(sheet.curves[0], {false});
        CurveStyle style;
        style.width = 3;
        style.marker = Marker::diamond;
        style.hasLabels = false;
        sheet.curves[1] = withStyle(sheet.curves[1], style);
        sheet.view.activeCurve = 1;
        sheet.view.layers[std::string(layersOf(index).front().name)] = !layersOf(index).front().isShownAtFirst;
    }
    /// As a canvas has it, which draws each curve by itself.
    [[nodiscard]] Figure onCanvas(std::optional<int> stage) const {
        std::vector<Figure> figures;
        for (int i = 0; i < static_cast<int>(sheet.curves.size()); ++i) {
            const Curve& curve = sheet.curves[static_cast<std::size_t>(i)];
            WorkBudget unlimited;
            if (viewOf(curve).isShown)
                figures.push_back(drawn(curve, contextOf(sheet, i, stage), unlimited).value().figure);
        }
        return united(std::move(figures), layersOf(index));
    }

    const SheetIndex index = GetParam();
    Sheet sheet;
};

TEST_P(FigureOfSheet, isTheSameOnACanvasAndInAnExport) {
    for (const std::optional<int> stage : {std::optional<int>(), std::optional(0), std::optional(2)})
        EXPECT_EQ(onCanvas(stage), figureOfCurves(sheet, index, stage)) << stage.value_or(-1);
}

TEST_P(FigureOfSheet, hidesLayersAfterAStage) {
    int last = 0;
    for (const LayerInfo& layer : layersOf(index))
        last = std::max(last, layer.stage);
    EXPECT_EQ(figureOf(sheet, index, last + 1), figureOf(sheet, index));
    EXPECT_TRUE(last == 0 || figureOf(sheet, index, 0) != figureOf(sheet, index));
}

TEST_P(FigureOfSheet, atAFrameIsThatOfTheActiveCurveThere) {
    const bool isAnimated =
        std::visit([](const auto& curve) { return curve.kCapabilities.animation; }, sheet.curves[1]);
    const std::optional<Frame<Sheet>> frame = atFrame(sheet, {FramePlace::Over::stage, 1});
    ASSERT_EQ(frame.has_value(), isAnimated);
    if (!frame)
        return;
    EXPECT_EQ(frame->value.curves[0], sheet.curves[0]);
    EXPECT_EQ(frame->value.curves[2], sheet.curves[2]);
    EXPECT_EQ(frame->value.view, sheet.view);
    EXPECT_FALSE(atFrame(Sheet(), {FramePlace::Over::stage, 1}));
}

INSTANTIATE_TEST_SUITE_P(OfEachSheet, FigureOfSheet, testing::Range<SheetIndex>(0, kSheetCount));

} // namespace
} // namespace kriva
