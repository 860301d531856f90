#pragma once

#include "core/bezier/evaluate.h"
#include "core/sheets/combined/combined.h"
#include "tests/support/sheet_curves.h"
#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QLabel>

namespace kriva::test {

inline const Point kEmptyPlace{4, -1}; ///< off the curve of GestureTest
inline constexpr Qt::KeyboardModifiers kCtrlAlt = Qt::ControlModifier | Qt::AltModifier;

/// The real window with one curve in each tab, through (0, 0), (2, 4), (6, 4), (8, 0), and a hand on a tab's canvas:
/// its events are what the system sends.
class GestureTest {
  public:
    explicit GestureTest(SheetIndex shown)
        : sheet(shown) {
        Document figure;
        figure.active = sheet;
        for (SheetIndex i = 0; i < kSheetCount; ++i)
            figure.sheets[i].curves.push_back(arc(i));
        figure.sheets[test::kSubdivision].view.layers["curve"] = true;
        window.window.session().show(std::move(figure));
        window.shown(sheet);
        canvas.setMapping({.scale = 40, .centre = {4, 2}, .size = QSizeF(canvas.viewport()->size()), .unitScale = 40});
        before = curve();
    }

    static Curve arc(SheetIndex i) {
        Curve curve = emptyCurve(i);
        for (const Point at : {Point{0, 0}, Point{2, 4}, Point{6, 4}, Point{8, 0}})
            curve = withPointAdded(std::move(curve), at).curve;
        return curve;
    }
    /// The middle of the arc, which lies on no grip.
    [[nodiscard]] Point middle() const {
        if (const auto* spline = std::get_if<SplineCurve>(&before))
            return evaluate(solveSpline(*spline).segments[1], 0.5);
        if (const auto* combined = std::get_if<CombinedCurve>(&before))
            return evaluate(combine(*combined).path[0].curve.points, 0.5);
        Points points;
        for (int i = 0; i < static_cast<int>(pointCount(before)); ++i)
            points.push_back(pointAt(before, i));
        return evaluate(points, 0.5);
    }

    [[nodiscard]] const Curve& curve() { return *tab.editor().activeCurve(); }
    [[nodiscard]] int count() { return static_cast<int>(pointCount(curve())); }
    [[nodiscard]] Point point(int index) { return pointAt(curve(), index); }
    [[nodiscard]] const SplineCurve& spline() { return std::get<SplineCurve>(curve()); }
    [[nodiscard]] const SplineKnot& knot(int index) { return spline().knots[static_cast<std::size_t>(index)]; }
    ui::OpenDocument& document() { return window.window.document(); }
    void use(AnyCurve value) {
        Document figure = document().value();
        figure.sheets[sheet].curves = {value};
        use(std::move(figure));
        before = std::move(value);
    }
    void useEmptySheet() {
        Document figure;
        figure.active = sheet;
        use(std::move(figure));
    }
    /// The names of all steps.
    [[nodiscard]] QStringList steps() {
        document().endGesture(); // a burst of keys
        QStringList names;
        for (int i = 0; i < document().history(sheet).count(); ++i)
            names.append(ui::resolvedStep(document().history(sheet).text(i)));
        return names;
    }
    /// One step of this name, which undo takes back to the curve as it was.
    void expectOneStep(const char* name) {
        EXPECT_EQ(steps(), QStringList{QString::fromUtf8(name)});
        EXPECT_NE(curve(), before);
        document().undo();
        EXPECT_EQ(curve(), before);
        document().redo();
    }
    void expectNoStep() {
        EXPECT_EQ(steps(), QStringList());
        EXPECT_EQ(curve(), before);
        EXPECT_FALSE(document().isModified());
    }
    [[nodiscard]] QString hint() { return window.window.findChild<QLabel*>(QStringLiteral("hint"))->text(); }
    [[nodiscard]] QAction& action(const char* name) {
        auto* ofTab = canvas.findChild<QAction*>(QString::fromLatin1(name));
        return ofTab ? *ofTab : *window.window.findChild<QAction*>(QString::fromLatin1(name));
    }

    void press(Point at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
        buttons |= button;
        send(QEvent::MouseButtonPress, at, button, keys);
    }
    void move(Point at, Qt::KeyboardModifiers keys = {}) { send(QEvent::MouseMove, at, Qt::NoButton, keys); }
    void release(Point at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
        buttons &= ~Qt::MouseButtons(button);
        send(QEvent::MouseButtonRelease, at, button, keys);
    }
    void click(Point at, Qt::KeyboardModifiers keys = {}, Qt::MouseButton button = Qt::LeftButton) {
        press(at, keys, button);
        release(at, keys, button);
    }
    void doubleClick(Point at) {
        click(at);
        buttons |= Qt::LeftButton;
        send(QEvent::MouseButtonDblClick, at, Qt::LeftButton, {});
        release(at);
    }
    /// In three moves.
    void drag(Point from, Point to, Qt::KeyboardModifiers keys = {}) {
        press(from, keys);
        for (const double part : {0.3, 0.6, 1.0})
            move(lerp(from, to, part), keys);
        release(to, keys);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(&canvas, key, keys); }
    /// A key that goes down, or up, and nothing else; `keys` are those held before.
    void hold(Qt::Key key, Qt::KeyboardModifiers keys = {}) { send(QEvent::KeyPress, key, keys); }
    void letGo(Qt::Key key, Qt::KeyboardModifiers keys = {}) { send(QEvent::KeyRelease, key, keys); }

    TestWindow window;
    SheetIndex sheet;
    ui::SheetTab& tab = window.window.tab(sheet);
    ui::CanvasView& canvas = tab.canvas();
    Curve before;

  private:
    void use(Document figure) {
        const ui::Viewport seen = canvas.mapping();
        window.window.session().show(std::move(figure));
        canvas.setMapping(seen);
    }
    void send(QEvent::Type type, Point at, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
        const QPointF pixel = canvas.mapping().toPixels(at);
        QMouseEvent event(type, pixel, canvas.viewport()->mapToGlobal(pixel), button, buttons, keys);
        QApplication::sendEvent(canvas.viewport(), &event);
    }
    void send(QEvent::Type type, Qt::Key key, Qt::KeyboardModifiers keys) {
        QKeyEvent event(type, key, keys);
        QApplication::sendEvent(&canvas, &event);
    }

    Qt::MouseButtons buttons;
};

inline bool isNear(Point a, Point b) {
    return distance(a, b) < 1e-9;
}

} // namespace kriva::test
