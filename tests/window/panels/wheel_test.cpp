#include "tests/support/panel_test.h"
#include "ui/export/export_dialog.h"
#include "ui/panels/style_editor.h"
#include "ui/tabs/properties/properties_area.h"

#include <QComboBox>
#include <QScrollBar>
#include <QWheelEvent>

namespace kriva::ui {
namespace {

/// A notch of the wheel over the middle of a widget, towards the person or away.
bool turnWheel(QWidget& widget, int angle) {
    const QPointF at = QRectF(widget.rect()).center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QSpontaneKeyEvent::setSpontaneous(&event); // as the system sends it: only then it goes on from child to parent
    qApp->notify(&widget, &event);
    QApplication::processEvents();
    return event.isAccepted();
}

/// All that the wheel could turn.
std::vector<QWidget*> fieldsOf(QWidget& window) {
    std::vector<QWidget*> fields;
    for (auto* widget : window.findChildren<QWidget*>()) {
        const bool turns = qobject_cast<QSlider*>(widget) || qobject_cast<QComboBox*>(widget) ||
                           qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QLineEdit*>(widget);
        if (turns && widget->isVisible())
            fields.push_back(widget);
    }
    return fields;
}

class WheelInEachTab : public test::PanelTest, public testing::WithParamInterface<SheetIndex> {
  protected:
    WheelInEachTab()
        : PanelTest(GetParam()) {
        test::seeAllPanels(tab);
        tab.findChild<StyleEditor*>()->show();
    }
};

TEST_P(WheelInEachTab, changesNothingThatHasNoFocus) {
    std::size_t seen = 0;
    for (QDockWidget* dock : tab.findChildren<QDockWidget*>()) {
        dock->raise();
        QApplication::processEvents();
        for (QWidget* field : fieldsOf(*dock)) {
            tab.canvas().setFocus();
            const Document before = document().value();
            for (const int angle : {120, -120, 120, 120, -120})
                turnWheel(*field, angle);
            EXPECT_TRUE(document().value() == before) << field->accessibleName().toStdString();
            EXPECT_FALSE(field->hasFocus()) << "nor does it take the focus";
            EXPECT_FALSE(editor().hasStage());
            ++seen;
        }
    }
    EXPECT_GT(seen, 3u);
    EXPECT_EQ(steps(), QStringList());
}

TEST_P(WheelInEachTab, turnsTheSliderThatHasTheFocus) {
    auto& area = panel<PropertiesArea>("properties");
    auto* slider = area.findChild<QSlider*>();
    ASSERT_NE(slider, nullptr);
    slider->setFocus();
    ASSERT_TRUE(slider->hasFocus());
    const int before = slider->value();
    turnWheel(*slider, slider->value() == slider->maximum() ? -120 : 120);
    EXPECT_NE(slider->value(), before);
    EXPECT_EQ(steps().size(), 1);
}

TEST_P(WheelInEachTab, scrollsThePanelOverAFieldWithoutFocus) {
    auto& area = panel<PropertiesArea>("properties");
    shell.window.resize(shell.window.width(), 380);
    QApplication::processEvents();
    ASSERT_GT(area.verticalScrollBar()->maximum(), 0);
    tab.canvas().setFocus();
    for (QWidget* field : fieldsOf(area)) {
        area.verticalScrollBar()->setValue(0);
        turnWheel(*field, -120);
        EXPECT_GT(area.verticalScrollBar()->value(), 0) << field->metaObject()->className();
    }
    EXPECT_EQ(steps(), QStringList());
}

INSTANTIATE_TEST_SUITE_P(InEachTab, WheelInEachTab, testing::Range<SheetIndex>(0, kSheetCount));

TEST(WheelInTheExportDialog, changesNothingThatHasNoFocus) {
    test::TestWindow shell;
    ExportDialog dialog(sheetToExport(shell.window.document().value(), test::kSubdivision), {}, shell.window.workers());
    dialog.show();
    QApplication::processEvents();
    const FigureFileOptions before = dialog.options();
    std::size_t choices = 0;
    for (QWidget* field : fieldsOf(dialog)) {
        dialog.findChild<QCheckBox*>()->setFocus();
        turnWheel(*field, -120);
        turnWheel(*field, -120);
        choices += qobject_cast<QComboBox*>(field) ? 1 : 0;
    }
    EXPECT_EQ(choices, 2u);
    EXPECT_TRUE(dialog.options() == before);
}

} // namespace
} // namespace kriva::ui
