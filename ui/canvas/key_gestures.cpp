#include "ui/canvas/key_gestures.h"

#include "ui/canvas/base/grid.h"
#include "ui/canvas/canvas_view.h"
#include "ui/canvas/gestures.h"

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>

#include <algorithm>
#include <string_view>

namespace kriva::ui {
namespace {

// X11 and Wayland number keys as the kernel does (linux/input-event-codes.h), plus 8: rows of the keyboard in order.
struct KeyRow {
    quint32 firstCode;
    std::string_view keys;
};
constexpr KeyRow kRows[] = {{10, "1234567890"}, {24, "QWERTYUIOP"}, {38, "ASDFGHJKL"}, {52, "ZXCVBNM"}};

constexpr double kLongNudge = 10; ///< grid steps with Shift

[[nodiscard]] bool hasKernelCodes() {
    const QString platform = QGuiApplication::platformName();
    return platform == u"xcb" || platform.startsWith(u"wayland");
}

/// The keypad's arrows and Delete are the same as the others.
[[nodiscard]] Qt::KeyboardModifiers modifiersOf(const QKeyEvent& event) {
    return event.modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
}

[[nodiscard]] std::optional<Vector> arrowOf(int key) {
    switch (key) {
    case Qt::Key_Left:
        return Vector{-1, 0};
    case Qt::Key_Right:
        return Vector{1, 0};
    case Qt::Key_Up:
        return Vector{0, 1};
    case Qt::Key_Down:
        return Vector{0, -1};
    default:
        return std::nullopt;
    }
}

[[nodiscard]] bool isSingleKey(Qt::Key key) {
    return key == Qt::Key_V || key == Qt::Key_B || key == Qt::Key_3 || key == Qt::Key_G;
}

/// The action whose only key is the physical one.
[[nodiscard]] QAction* actionFor(const QKeyEvent& event, const QList<QAction*>& actions) {
    const QKeySequence pressed(QKeyCombination(modifiersOf(event), physicalKey(event)));
    const auto found = std::ranges::find_if(
        actions, [&](const QAction* action) { return action->isEnabled() && action->shortcuts().contains(pressed); });
    return found == actions.end() ? nullptr : *found;
}

} // namespace

KeyGestures::KeyGestures(CanvasView& view, Gestures& mouse, CanvasInput& input)
    : view_(view)
    , mouse_(mouse)
    , input_(input) {}

bool KeyGestures::wants(const QKeyEvent& event) const {
    const Qt::KeyboardModifiers modifiers = modifiersOf(event);
    if (arrowOf(event.key()))
        return modifiers == Qt::NoModifier || modifiers == Qt::ShiftModifier || modifiers == Qt::AltModifier;
    switch (event.key()) {
    case Qt::Key_Escape:
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
        return modifiers == Qt::NoModifier;
    case Qt::Key_Space:
        return modifiers == Qt::NoModifier || mouse_.isRunning();
    case Qt::Key_Delete:
        return modifiers == Qt::NoModifier || modifiers == Qt::ControlModifier;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return modifiers == Qt::NoModifier && view_.tool() == Tool::add;
    default:
        break;
    }
    if (modifiers != Qt::NoModifier && modifiers != Qt::ShiftModifier)
        return false;
    return (modifiers == Qt::NoModifier && isSingleKey(physicalKey(event))) ||
           actionFor(event, view_.actions()) != nullptr;
}

bool KeyGestures::press(const QKeyEvent& event) {
    if (!wants(event))
        return false;
    if (event.key() == Qt::Key_Escape) {
        escape();
        return true;
    }
    if (event.key() == Qt::Key_Space) {
        mouse_.setSpaceHeld(true);
        return true;
    }
    if (mouse_.isRunning())
        return true; // the mouse is at work
    if (const auto direction = arrowOf(event.key())) {
        nudge(*direction, modifiersOf(event));
        return true;
    }
    switch (event.key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (!view_.scene().selection().empty())
            input_.removeSelected(event.modifiers().testFlag(Qt::ControlModifier) ? Removal::plain : Removal::refitted);
        return true;
    case Qt::Key_Insert:
        insert();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        view_.setTool(Tool::edit);
        return true;
    default:
        return pressSingleKey(event);
    }
}

bool KeyGestures::pressSingleKey(const QKeyEvent& event) {
    if (QAction* action = actionFor(event, view_.actions())) {
        action->trigger();
        return true;
    }
    switch (physicalKey(event)) {
    case Qt::Key_V:
        view_.setTool(Tool::edit);
        return true;
    case Qt::Key_B:
        view_.setTool(Tool::add);
        return true;
    case Qt::Key_3:
        view_.fitSelection();
        return true;
    case Qt::Key_G:
        view_.scene().setGridShown(!view_.scene().isGridShown());
        return true;
    default:
        return false;
    }
}

void KeyGestures::insert() {
    input_.insertPoint(mouse_.curveUnderPointer());
    mouse_.follow(Qt::NoModifier);
}

void KeyGestures::nudge(Vector direction, Qt::KeyboardModifiers modifiers) {
    if (view_.scene().selection().empty())
        return;
    double step = gridStep(view_.mapping());
    if (modifiers == Qt::ShiftModifier)
        step *= kLongNudge;
    else if (modifiers == Qt::AltModifier)
        step = 1 / view_.mapping().scale;
    input_.nudge(step * direction);
}

void KeyGestures::escape() {
    if (mouse_.isRunning())
        mouse_.cancel();
    else if (view_.tool() == Tool::add)
        view_.setTool(Tool::edit);
    else if (!view_.scene().selection().empty())
        input_.select({});
    else
        view_.leave();
}

bool KeyGestures::walk(bool isForwards) {
    if (mouse_.isRunning())
        return true;
    const auto next = neighbourOfSelection(isForwards);
    hasWalkedOut_ = !next;
    if (!next)
        return false;
    view_.choose(*next);
    return true;
}

std::optional<GripRef> KeyGestures::neighbourOfSelection(bool isNext) const {
    std::vector<GripRef> points = view_.scene().curves().points();
    if (!isNext)
        std::ranges::reverse(points);
    const auto isSelected = [&](const GripRef& point) { return view_.scene().selection().contains(point); };
    const auto last = hasWalkedOut_ ? points.rend() : std::find_if(points.rbegin(), points.rend(), isSelected);
    const auto next = last.base(); // the one after it; the first one where none is selected
    return next == points.end() ? std::nullopt : std::optional(*next);
}

Qt::Key physicalKey(const QKeyEvent& event) {
    const quint32 code = event.nativeScanCode();
    if (code != 0 && hasKernelCodes())
        for (const KeyRow& row : kRows)
            if (code >= row.firstCode && code - row.firstCode < row.keys.size())
                return static_cast<Qt::Key>(row.keys[code - row.firstCode]); // Qt::Key_A is 'A'
    return static_cast<Qt::Key>(event.key());
}

} // namespace kriva::ui
