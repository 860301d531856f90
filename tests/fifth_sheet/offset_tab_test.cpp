#include "core/sheets/offset/offset.h"
#include "tests/support/panel_test.h"
#include "ui/export/export_subject.h"
#include "ui/panels/guide/guide_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/tabs/properties/properties_panel.h"

#include <QTabBar>

namespace kriva::ui {
namespace {

const SheetIndex kOffset = sheetNamed("offset").value();

class OffsetTab : public test::PanelTest {
  protected:
    OffsetTab()
        : PanelTest(kOffset) {
        OffsetCurve corner;
        corner.points = {{0, 0}, {4, 0}, {4, 3}};
        open({corner});
    }
    [[nodiscard]] OffsetCurve offset() { return value<OffsetCurve>(); }

    const OffsetCurve before = offset();
};

TEST_F(OffsetTab, standsBehindTheOthersAndHasItsShortcut) {
    EXPECT_EQ(shell.window.sheetTitle(kOffset), QStringLiteral("Offset"));
    shell.window.document().setActiveSheet(0);
    QTest::keyClick(&shell.window, Qt::Key_5, Qt::AltModifier);
    EXPECT_EQ(document().value().active, kOffset);
}

TEST_F(OffsetTab, takesPointsFromTheCanvasInStepsThatAreUndone) {
    editor().addPoint({0, 3});
    EXPECT_EQ(offset().points.size(), 4u);
    EXPECT_EQ(steps().size(), 1);
    document().undo();
    EXPECT_EQ(offset(), before);
    document().redo();
    EXPECT_EQ(offset().points.back(), (Point{0, 3}));
}

TEST_F(OffsetTab, movesAPointByADragInOneStep) {
    const QPoint from = test::pixelOf(tab, 1);
    QTest::mousePress(tab.canvas().viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(tab.canvas().viewport(), from + QPoint(10, 20));
    QTest::mouseMove(tab.canvas().viewport(), from + QPoint(30, 40));
    QTest::mouseRelease(tab.canvas().viewport(), Qt::LeftButton, {}, from + QPoint(30, 40));
    EXPECT_NE(offset().points[1], before.points[1]);
    EXPECT_EQ(steps().size(), 1);
    document().undo();
    EXPECT_EQ(offset(), before);
}

TEST_F(OffsetTab, itsPropertiesAreSetInOneStepEach) {
    auto& properties = panel<PropertiesPanel>("properties");
    test::type(test::named<NumberField>(properties, "Distance"), "2.5");
    OffsetCurve after = before;
    after.distance = 2.5;
    expectOneStep("Set the distance", before, after);
    QTest::keyClick(&tab.canvas(), Qt::Key_PageUp);
    after = before;
    after.times = 2;
    expectOneStep("Set the number of polygons", before, after);
}

TEST_F(OffsetTab, itsLayersAndItsGuideAreThere) {
    EXPECT_EQ(panel<LayersPanel>("layers").findChildren<QWidget*>().isEmpty(), false);
    EXPECT_TRUE(panel<GuidePanel>("guide").toPlainText().contains(QStringLiteral("Offset polygons")));
}

TEST_F(OffsetTab, isExportedAsItIsOnView) {
    const ExportSubject subject = sheetToExport(document().value(), kOffset);
    EXPECT_EQ(subject.layers.size(), layersOf(kOffset).size());
    EXPECT_TRUE(subject.hasFrames);
    WorkBudget unlimited;
    const Drawing drawing = subject.drawing({}, unlimited);
    EXPECT_FALSE(drawing.figure.layers.empty());
    EXPECT_EQ(drawing.description, "Offset polygons: Offset polygons, Curve, Points, Labels");
}

} // namespace
} // namespace kriva::ui
