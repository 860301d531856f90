#include "ui/window/dialogs/gesture_table.h"

#include "core/document/document.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

[[nodiscard]] GestureGroup tabs() {
    return {QT_TRANSLATE_NOOP("Gestures", "Tabs"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Show a tab"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt+1 … Alt+%1"),
                 {},
                 static_cast<int>(kSheetCount)},
                {QT_TRANSLATE_NOOP("Gestures", "Next tab"), nullptr, QKeySequence(Qt::CTRL | Qt::Key_Tab)},
            }};
}

[[nodiscard]] GestureGroup points() {
    return {QT_TRANSLATE_NOOP("Gestures", "Points, with the mouse"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Select a point, or make a curve the active one"),
                 QT_TRANSLATE_NOOP("Gestures", "Click")},
                {QT_TRANSLATE_NOOP("Gestures", "Select or deselect one more point"),
                 QT_TRANSLATE_NOOP("Gestures", "Shift+click")},
                {QT_TRANSLATE_NOOP("Gestures", "Select all points in a rectangle"),
                 QT_TRANSLATE_NOOP("Gestures", "Drag on the empty canvas")},
                {QT_TRANSLATE_NOOP("Gestures", "Add the points in a rectangle to the selection"),
                 QT_TRANSLATE_NOOP("Gestures", "Shift+drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Take the points in a rectangle out of the selection"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt+drag or Ctrl+Shift+drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Add a point at the end of the curve"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt+click, or double-click on the empty canvas")},
                {QT_TRANSLATE_NOOP("Gestures", "Insert a point and keep the shape"),
                 QT_TRANSLATE_NOOP("Gestures", "Double-click or Ctrl+Alt+click on the curve")},
                {QT_TRANSLATE_NOOP("Gestures", "Remove a point and refit its neighbours"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt+click on the point")},
                {QT_TRANSLATE_NOOP("Gestures", "Move a point or the selection"),
                 QT_TRANSLATE_NOOP("Gestures", "Drag the point")},
                {QT_TRANSLATE_NOOP("Gestures", "Move along an axis"), QT_TRANSLATE_NOOP("Gestures", "Ctrl+drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Move without snapping"),
                 QT_TRANSLATE_NOOP("Gestures", "Shift, pressed during the drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Mould the curve"), QT_TRANSLATE_NOOP("Gestures", "Drag the curve")},
                {QT_TRANSLATE_NOOP("Gestures", "What can be done here"), QT_TRANSLATE_NOOP("Gestures", "Right-click")},
            }};
}

[[nodiscard]] GestureGroup addTool() {
    return {QT_TRANSLATE_NOOP("Gestures", "Add tool"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Add a point, or insert one on the curve"),
                 QT_TRANSLATE_NOOP("Gestures", "Click")},
                {QT_TRANSLATE_NOOP("Gestures", "Pull the handles of the new knot"),
                 QT_TRANSLATE_NOOP("Gestures", "Press and drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Close the curve"),
                 QT_TRANSLATE_NOOP("Gestures", "Click on the first knot")},
                {QT_TRANSLATE_NOOP("Gestures", "End"), QT_TRANSLATE_NOOP("Gestures", "Enter or Esc")},
            }};
}

[[nodiscard]] GestureGroup handles() {
    return {QT_TRANSLATE_NOOP("Gestures", "Handles and end derivatives"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Turn in steps of 15°"), QT_TRANSLATE_NOOP("Gestures", "Ctrl+drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Keep the angle"), QT_TRANSLATE_NOOP("Gestures", "Ctrl+Alt+drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Leave the other handle where it is"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt, pressed during the drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Carry the knot along"),
                 QT_TRANSLATE_NOOP("Gestures", "Space, held during the drag")},
                {QT_TRANSLATE_NOOP("Gestures", "Retract the handle"), QT_TRANSLATE_NOOP("Gestures", "Ctrl+click")},
            }};
}

[[nodiscard]] GestureGroup canvasKeys() {
    return {QT_TRANSLATE_NOOP("Gestures", "Keys on the canvas"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Edit tool"), nullptr, QKeySequence(Qt::Key_V)},
                {QT_TRANSLATE_NOOP("Gestures", "Add tool"), nullptr, QKeySequence(Qt::Key_B)},
                {QT_TRANSLATE_NOOP("Gestures", "Fit the selection"), nullptr, QKeySequence(Qt::Key_3)},
                {QT_TRANSLATE_NOOP("Gestures", "Grid"), nullptr, QKeySequence(Qt::Key_G)},
                {QT_TRANSLATE_NOOP("Gestures", "Next point"), nullptr, QKeySequence(Qt::Key_Tab)},
                {QT_TRANSLATE_NOOP("Gestures", "Previous point"), nullptr, QKeySequence(Qt::SHIFT | Qt::Key_Tab)},
                {QT_TRANSLATE_NOOP("Gestures", "Move the selection by a step of the grid"),
                 QT_TRANSLATE_NOOP("Gestures", "Arrow keys")},
                {QT_TRANSLATE_NOOP("Gestures", "Move the selection by ten steps"),
                 QT_TRANSLATE_NOOP("Gestures", "Shift+arrow keys")},
                {QT_TRANSLATE_NOOP("Gestures", "Move the selection by a pixel"),
                 QT_TRANSLATE_NOOP("Gestures", "Alt+arrow keys")},
                {QT_TRANSLATE_NOOP("Gestures", "Remove the selection and refit its neighbours"),
                 QT_TRANSLATE_NOOP("Gestures", "Delete or Backspace")},
                {QT_TRANSLATE_NOOP("Gestures", "Remove the selection without refitting"), nullptr,
                 QKeySequence(Qt::CTRL | Qt::Key_Delete)},
                {QT_TRANSLATE_NOOP("Gestures", "Take back the drag, end the tool, deselect, leave the canvas"), nullptr,
                 QKeySequence(Qt::Key_Escape)},
            }};
}

[[nodiscard]] GestureGroup view() {
    return {QT_TRANSLATE_NOOP("Gestures", "View, with the mouse"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Scroll"), QT_TRANSLATE_NOOP("Gestures", "Wheel")},
                {QT_TRANSLATE_NOOP("Gestures", "Scroll sideways"), QT_TRANSLATE_NOOP("Gestures", "Shift+wheel")},
                {QT_TRANSLATE_NOOP("Gestures", "Zoom at the pointer"), QT_TRANSLATE_NOOP("Gestures", "Ctrl+wheel")},
                {QT_TRANSLATE_NOOP("Gestures", "Move the sheet"),
                 QT_TRANSLATE_NOOP("Gestures", "Drag with the middle button or with Space")},
            }};
}

[[nodiscard]] GestureGroup player() {
    return {QT_TRANSLATE_NOOP("Gestures", "Player"),
            {
                {QT_TRANSLATE_NOOP("Gestures", "Play or pause"), nullptr, QKeySequence(Qt::Key_Space)},
                {QT_TRANSLATE_NOOP("Gestures", "One step back or forth"), QT_TRANSLATE_NOOP("Gestures", "Left, Right")},
            }};
}

} // namespace

std::vector<GestureGroup> gestureTable() {
    return {canvasKeys(), points(), addTool(), handles(), view(), tabs(), player()};
}

} // namespace kriva::ui
