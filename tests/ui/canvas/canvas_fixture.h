#pragma once

#include "ui/canvas/canvas_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QMouseEvent>
#include <QStringList>
#include <QtTest/QTest>
#include <QWheelEvent>

namespace kriva::ui {

/// Notes every call in a few words, rounded to whole units, and lets the canvas show the selection asked for.
class RecordingInput : public CanvasInput {
  public:
    void hover(const PointerEvent& now) override {
        hovered = now.under;
        hoverModifiers = now.modifiers;
    }
    void click(const PointerEvent& press) override {
        note(press.button == Qt::RightButton ? QStringLiteral("right click ") : QStringLiteral("click "), press);
    }
    bool doubleClick(const PointerEvent& press) override {
        if (press.under.grip)
            return false;
        note(QStringLiteral("double click "), press);
        return true;
    }
    bool beginDrag(const PointerEvent& press) override {
        if (!press.under.grip || press.with(Qt::AltModifier))
            return false;
        note(QStringLiteral("begin "), press);
        return true;
    }
    void drag(Vector by, const DragKeys& keys) override {
        note(QStringLiteral("drag ") + text({by.x, by.y}));
        dragKeys = keys;
    }
    void endDrag() override { note(QStringLiteral("end")); }
    void cancelDrag() override { note(QStringLiteral("cancel")); }
    void select(Selection selection) override {
        QString names;
        for (const GripRef& grip : selection)
            names += u' ' + text(grip);
        note(QStringLiteral("select") + names);
        view->scene().setSelection(std::move(selection));
    }
    void nudge(Vector by) override { note(QStringLiteral("nudge ") + text({by.x, by.y})); }
    void removeSelected(Removal removal) override {
        note(removal == Removal::plain ? QStringLiteral("remove selected plainly") : QStringLiteral("remove selected"));
    }
    void insertPoint(std::optional<CurvePlace> place) override {
        note(place ? QStringLiteral("insert into %1 ").arg(place->curve) + text(place->near)
                   : QStringLiteral("insert"));
    }

    CanvasView* view = nullptr;
    QStringList log;
    Hit hovered;
    DragKeys dragKeys;
    Qt::KeyboardModifiers hoverModifiers;

  private:
    void note(const QString& call) { log.append(call); }
    /// Where, and on what: a grip, a curve, a mark.
    void note(const QString& call, const PointerEvent& event) {
        const auto& [grip, curve, mark] = event.under;
        note(call + text(event.at) + (grip ? QStringLiteral(" on ") + text(*grip) : QString()) +
             (curve ? QStringLiteral(" on %1").arg(*curve) : QString()) +
             (mark ? QStringLiteral(" on mark ") + text(mark->at) : QString()));
    }
    static QString text(Point p) { return QStringLiteral("%1,%2").arg(qRound(p.x)).arg(qRound(p.y)); }
    static QString text(const GripRef& grip) {
        const QString handle = grip.id.kind == GripKind::point ? QString() : QStringLiteral("h");
        return QStringLiteral("%1%3:%2").arg(grip.serial).arg(grip.id.index).arg(handle);
    }
};

/// Sends a canvas the events that the system would, at places of the document.
class CanvasEvents {
  protected:
    explicit CanvasEvents(CanvasView& canvas)
        : view(canvas) {}

    /// 400 x 400 pixels with the origin in the middle, a unit to a pixel, in the active window.
    void show() {
        view.resize(400, 400);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setFocus();
        view.setMapping({.scale = 1, .centre = {}, .size = QSizeF(view.viewport()->size()), .unitScale = 1});
    }
    void press(Point at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        buttons |= button;
        send(QEvent::MouseButtonPress, at, button, modifiers);
    }
    void pressAgain(Point at, Qt::KeyboardModifiers modifiers = {}) {
        buttons |= Qt::LeftButton;
        send(QEvent::MouseButtonDblClick, at, Qt::LeftButton, modifiers);
    }
    void move(Point at, Qt::KeyboardModifiers modifiers = {}) { send(QEvent::MouseMove, at, Qt::NoButton, modifiers); }
    void release(Point at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::LeftButton) {
        buttons &= ~Qt::MouseButtons(button);
        send(QEvent::MouseButtonRelease, at, button, modifiers);
    }
    void click(Point at, Qt::KeyboardModifiers modifiers = {}) {
        press(at, modifiers);
        release(at, modifiers);
    }
    /// Press, one movement, release.
    void drag(Point from, Point to, Qt::KeyboardModifiers modifiers = {}) {
        press(from, modifiers);
        move(to, modifiers);
        release(to, modifiers);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }
    void holdModifier(Qt::Key key) { sendKey(QEvent::KeyPress, key, Qt::NoModifier); }
    void letGoModifier(Qt::Key key, Qt::KeyboardModifier modifier) { sendKey(QEvent::KeyRelease, key, modifier); }
    void turnWheel(Point at, QPoint angle, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF pixel = view.mapping().toPixels(at);
        QWheelEvent event(pixel, view.viewport()->mapToGlobal(pixel), {}, angle, buttons, modifiers, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(view.viewport(), &event);
    }
    void send(QEvent::Type type, Point at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        const QPointF pixel = view.mapping().toPixels(at);
        QMouseEvent event(type, pixel, view.viewport()->mapToGlobal(pixel), button, buttons, modifiers);
        QApplication::sendEvent(view.viewport(), &event);
    }
    /// `modifiers` are those held before the event, as the system tells them.
    void sendKey(QEvent::Type type, Qt::Key key, Qt::KeyboardModifiers modifiers) {
        QKeyEvent event(type, key, modifiers);
        QApplication::sendEvent(&view, &event);
    }

    CanvasView& view;
    Qt::MouseButtons buttons;
};

struct RecordedCanvas {
    RecordingInput input;
    CanvasView canvas{input};
};

/// A canvas with one parabola: points 1:0, 1:1, 1:2 at (-100, 0), (0, 100), (100, 0), the curve's top at (0, 50), and a
/// handle 1h:0 at (-100, -60).
class CanvasTest : public ::testing::Test, protected RecordedCanvas, protected CanvasEvents {
  protected:
    CanvasTest()
        : CanvasEvents(canvas) {
        input.view = &view;
        view.scene().setCurves({parabola()});
        show();
    }

    static CanvasCurve parabola() {
        const Points points{{-100, 0}, {0, 100}, {100, 0}};
        CanvasCurve curve{1, {{{"curve", {{.path = singleCurve(points)}}}}}, {}, true};
        for (int i = 0; i < 3; ++i)
            curve.grips.push_back({point(i).id, points[static_cast<std::size_t>(i)]});
        curve.grips.push_back({{GripKind::outHandle, 0, 0}, {-100, -60}});
        return curve;
    }
    static GripRef point(int index) { return {1, {GripKind::point, index, 0}}; }

    /// Since the last time.
    QStringList calls() { return std::exchange(input.log, {}); }
};

/// Lists that read well in a test's failure.
inline void PrintTo(const QStringList& list, std::ostream* out) {
    *out << list.join(QStringLiteral(" | ")).toStdString();
}
[[nodiscard]] inline QStringList list(std::initializer_list<const char*> words) {
    QStringList result;
    for (const char* word : words)
        result.append(QString::fromLatin1(word));
    return result;
}

} // namespace kriva::ui
