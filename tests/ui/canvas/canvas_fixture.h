#pragma once

#include "ui/canvas/canvas_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QMouseEvent>
#include <QStringList>
#include <QtTest/QTest>
#include <QWheelEvent>

namespace kriva::ui {

/// Notes every wish in a few words, rounded to whole units, and lets the canvas show the selection asked for.
class RecordingClient : public CanvasClient {
  public:
    void addPoint(Point at) override { note(QStringLiteral("add ") + text(at)); }
    void addPointOn(GripRef grip, Point at) override { note(QStringLiteral("add on %1 ").arg(text(grip)) + text(at)); }
    void insertPoint(Serial curve, Point at) override { note(QStringLiteral("insert into %1 ").arg(curve) + text(at)); }
    void insertPointBehindSelected() override { note(QStringLiteral("insert")); }
    void retractHandle(GripRef handle) override { note(QStringLiteral("retract ") + text(handle)); }
    void removePoint(GripRef grip) override { note(QStringLiteral("remove ") + text(grip)); }
    void removeSelected(Removal removal) override {
        note(removal == Removal::plain ? QStringLiteral("remove selected plainly") : QStringLiteral("remove selected"));
    }
    void select(Selection selection) override {
        QString names;
        for (const GripRef& grip : selection)
            names += u' ' + text(grip);
        note(QStringLiteral("select") + names);
        view->setSelection(std::move(selection));
    }
    void activateCurve(Serial curve) override { note(QStringLiteral("activate %1").arg(curve)); }
    void explain(const MarkPlace& mark) override { note(QStringLiteral("explain ") + text(mark.at)); }
    void beginDrag(GripRef grip) override { note(QStringLiteral("begin ") + text(grip)); }
    void beginAddDrag(Point at) override { note(QStringLiteral("begin adding ") + text(at)); }
    void beginInsertDrag(Serial curve, Point at) override {
        note(QStringLiteral("begin inserting %1 ").arg(curve) + text(at));
    }
    void beginCurveDrag(Serial curve, Point at) override {
        note(QStringLiteral("begin curve %1 ").arg(curve) + text(at));
    }
    void drag(Vector by, const DragKeys& keys) override {
        note(QStringLiteral("drag ") + text({by.x, by.y}));
        dragKeys = keys;
    }
    void endDrag() override { note(QStringLiteral("end")); }
    void cancelDrag() override { note(QStringLiteral("cancel")); }
    void nudge(Vector by) override { note(QStringLiteral("nudge ") + text({by.x, by.y})); }
    void hover(const Hit& under, Point, Qt::KeyboardModifiers modifiers) override {
        hovered = under;
        hoverModifiers = modifiers;
    }

    CanvasView* view = nullptr;
    QStringList log;
    Hit hovered;
    DragKeys dragKeys;
    Qt::KeyboardModifiers hoverModifiers;

  private:
    void note(const QString& wish) { log.append(wish); }
    static QString text(Point p) { return QStringLiteral("%1,%2").arg(qRound(p.x)).arg(qRound(p.y)); }
    static QString text(const GripRef& grip) {
        const QString handle = grip.id.kind == GripKind::point ? QString() : QStringLiteral("h");
        return QStringLiteral("%1%3:%2").arg(grip.serial).arg(grip.id.index).arg(handle);
    }
};

/// A canvas of 400 x 400 pixels with the origin in its middle, a unit to a pixel, and one parabola: points 1:0, 1:1,
/// 1:2 at (-100, 0), (0, 100), (100, 0), the curve's top at (0, 50), and a handle 1h:0 at (-100, -60).
class CanvasTest : public ::testing::Test {
  protected:
    CanvasTest()
        : view(client) {
        client.view = &view;
        view.resize(400, 400);
        view.setCurves({parabola()});
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
        view.setFocus();
        view.setMapping({.scale = 1, .centre = {}, .size = QSizeF(view.viewport()->size()), .unitScale = 1});
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
    /// What was wished since the last time.
    QStringList wishes() { return std::exchange(client.log, {}); }

    RecordingClient client;
    CanvasView view;
    Qt::MouseButtons buttons;
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
