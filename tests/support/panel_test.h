#pragma once

#include "tests/support/sheet_curves.h"
#include "tests/support/test_window.h"
#include "ui/controls/number_field.h"

#include <gtest/gtest.h>
#include <QCheckBox>
#include <QDockWidget>
#include <QSlider>
#include <QStyleOptionSlider>

#include <stdexcept>

namespace kriva::test {

/// The first widget of a kind that screen readers call by `name`; the test ends where there is none.
template <class W>
W& named(QWidget& parent, const char* name) {
    for (W* widget : parent.findChildren<W*>())
        if (widget->accessibleName() == QLatin1String(name))
            return *widget;
    throw std::runtime_error(std::string("no widget is called ") + name);
}

/// The first button of a kind with this text.
template <class B>
B& saying(QWidget& parent, const char* text) {
    for (B* button : parent.findChildren<B*>())
        if (button->text() == QLatin1String(text))
            return *button;
    throw std::runtime_error(std::string("no button says ") + text);
}

inline void click(QWidget& widget) {
    QTest::mouseClick(&widget, Qt::LeftButton);
}
/// On its square: a wide box is empty in the middle.
inline void click(QCheckBox& box) {
    QTest::mouseClick(&box, Qt::LeftButton, {}, {box.height() / 2, box.height() / 2});
}
/// As a person does it: an item view wants the first press of the two as well.
inline void doubleClick(QWidget& widget, QPoint at) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
    QTest::mouseDClick(&widget, Qt::LeftButton, {}, at);
}

/// Replaces the text as a person does: mark all, type, Enter.
inline void type(QLineEdit& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    QTest::keyClicks(&field, QString::fromUtf8(text));
    QTest::keyClick(&field, Qt::Key_Return);
    QApplication::processEvents();
}

inline QPoint handleOf(const QSlider& slider) {
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.orientation = slider.orientation();
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = slider.sliderPosition();
    option.sliderValue = slider.value();
    return slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
}

/// Drags the handle sideways, pixel by pixel.
inline void dragHandle(QSlider& slider, int pixels) {
    const QPoint start = handleOf(slider);
    QTest::mousePress(&slider, Qt::LeftButton, {}, start);
    const int way = pixels < 0 ? -1 : 1;
    for (int x = way; x != pixels + way; x += way)
        QTest::mouseMove(&slider, start + QPoint(x, 0));
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, start + QPoint(pixels, 0));
}

/// One tab of the real window and the panels in it.
class PanelTest : public testing::Test {
  protected:
    explicit PanelTest(SheetIndex sheet)
        : sheet_(sheet)
        , tab(shell.shown(sheet)) {}

    /// Shows a document with these curves in the tab's sheet alone.
    void open(const std::vector<AnyCurve>& curves) {
        Document document;
        document.active = sheet_;
        document.sheets[sheet_].curves.assign(curves.begin(), curves.end());
        shell.window.session().show(document);
        QApplication::processEvents();
    }
    /// The panel of a dock, in front of its neighbours.
    template <class P>
    P& panel(const char* dock) {
        tab.findChild<QDockWidget*>(QString::fromLatin1(dock))->raise();
        QApplication::processEvents();
        return *tab.findChild<P*>();
    }

    [[nodiscard]] ui::OpenDocument& document() { return shell.window.document(); }
    [[nodiscard]] ui::SheetEditor& editor() { return tab.editor(); }
    [[nodiscard]] const Curve& curve() { return *editor().activeCurve(); }
    template <class C>
    [[nodiscard]] C value() {
        return std::get<C>(curve());
    }
    void selectPoints(const std::vector<int>& points) {
        ui::Selection selection;
        for (const int point : points)
            selection.insert({editor().activeSerial(), {GripKind::point, point}});
        editor().select(selection);
    }
    [[nodiscard]] QStringList steps() {
        document().endGesture();
        QStringList texts;
        for (int i = 0; i < document().history(sheet_).index(); ++i)
            texts.append(ui::resolvedStep(document().history(sheet_).text(i)));
        return texts;
    }
    /// One step of that name led from `before` to `after` and to nothing else; undo takes all of it back.
    void expectOneStep(const char* name, const AnyCurve& before, const AnyCurve& after) {
        EXPECT_EQ(steps(), QStringList(QString::fromUtf8(name)));
        EXPECT_TRUE(curve() == after);
        document().undo();
        EXPECT_TRUE(curve() == before);
    }
    /// Nothing happened.
    void expectNoStep(const AnyCurve& before) {
        EXPECT_EQ(steps(), QStringList());
        EXPECT_TRUE(curve() == before);
    }

    const SheetIndex sheet_;
    TestWindow shell;
    ui::SheetTab& tab;
};

} // namespace kriva::test
