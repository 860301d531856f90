#include "core/document/sheet_figure.h"
#include "tests/support/panel_test.h"
#include "ui/panels/layers_panel.h"

namespace kriva::ui {
namespace {

class LayersPanelTest : public test::PanelTest {
  protected:
    LayersPanelTest()
        : PanelTest(test::kElevation) {}
    [[nodiscard]] QImage canvas() {
        QApplication::processEvents();
        return tab.canvas().viewport()->grab().toImage();
    }
    [[nodiscard]] int row(std::string_view layer) {
        const auto infos = layersOf(0);
        const auto found = std::ranges::find(infos, layer, &LayerInfo::name);
        return static_cast<int>(found - infos.begin());
    }
    [[nodiscard]] bool isInFigure(std::string_view layer) {
        const Figure figure = figureOf(editor().sheet(), test::kElevation);
        return std::ranges::any_of(figure.layers, [&](const auto& drawn) { return drawn.name == layer; });
    }

    LayersPanel& layers = panel<LayersPanel>("layers");
};

TEST_F(LayersPanelTest, aCheckTakesTheLayerOffTheCanvasAndModifiesNothing) {
    const QImage before = canvas();
    EXPECT_TRUE(isInFigure("curve"));
    layers.setCurrentRow(row("curve"));
    QTest::keyClick(&layers, Qt::Key_Space);
    EXPECT_EQ(layers.currentItem()->checkState(), Qt::Unchecked);
    EXPECT_FALSE(isInFigure("curve"));
    EXPECT_NE(canvas(), before);
    EXPECT_EQ(steps(), QStringList());
    EXPECT_FALSE(document().isModified());
    QTest::keyClick(&layers, Qt::Key_Space);
    EXPECT_EQ(canvas(), before);
}

TEST_F(LayersPanelTest, showsWhatTheDocumentSays) {
    document().setLayerShown(test::kElevation, "curve", false);
    EXPECT_EQ(layers.item(row("curve"))->checkState(), Qt::Unchecked);
    shell.window.session().show({});
    EXPECT_EQ(layers.item(row("curve"))->checkState(), Qt::Checked);
}

} // namespace
} // namespace kriva::ui
