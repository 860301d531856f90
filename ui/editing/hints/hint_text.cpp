#include "ui/editing/hints/hint_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

constexpr Qt::KeyboardModifiers kCtrlAlt = Qt::ControlModifier | Qt::AltModifier;
constexpr Qt::KeyboardModifiers kCtrlShift = Qt::ControlModifier | Qt::ShiftModifier;

class Hints {
    Q_DECLARE_TR_FUNCTIONS(Hint)
  public:
    static QString overPoint(const HintSituation& now) {
        if (now.modifiers == Qt::AltModifier)
            return tr("Alt+click: remove the point");
        if (now.closes)
            return tr("Click: close the curve   Drag: move the point   Esc: end");
        if (now.tool == Tool::add)
            return tr("Click: add a point   Drag: move the point   Esc: end");
        if (now.modifiers == Qt::ControlModifier)
            return tr("Ctrl+drag: move the point along an axis");
        if (now.modifiers == Qt::ShiftModifier)
            return tr("Shift+click: select or deselect the point");
        return tr("Drag: move the point, Ctrl: along an axis   Alt+click: remove it");
    }
    static QString overHandle(Qt::KeyboardModifiers modifiers) {
        if (modifiers == Qt::ControlModifier)
            return tr("Ctrl+drag: steps of 15°   Ctrl+click: retract the handle");
        return tr("Drag: move the handle, Ctrl: in steps of 15°   Ctrl+click: retract it");
    }
    static QString overArrow(Qt::KeyboardModifiers modifiers) {
        if (modifiers == Qt::ControlModifier)
            return tr("Ctrl+drag: steps of 15°   Ctrl+click: back to the natural derivative");
        return tr("Drag: change the derivative, Ctrl: in steps of 15°   Ctrl+click: back to the natural one");
    }
    static QString overOther() { return tr("Drag: move the point, Ctrl: along an axis"); }
    static QString overCurve(const HintSituation& now) {
        if (now.modifiers == kCtrlAlt)
            return tr("Ctrl+Alt+click: insert a point");
        if (now.modifiers == Qt::AltModifier)
            return tr("Alt+click: add a point");
        if (now.tool == Tool::add && now.pullsHandles)
            return tr("Click: insert a point   Drag: pull its handles   Esc: end");
        if (now.tool == Tool::add)
            return tr("Click: insert a point   Drag: place it   Esc: end");
        return tr("Drag: mould the curve   Double-click: insert a point");
    }
    static QString overMark() { return tr("Click: how this point is worked out, in Tables"); }
    static QString overNothing(const HintSituation& now) {
        if (now.modifiers == Qt::AltModifier)
            return tr("Alt+click: add a point   Alt+drag: deselect points");
        if (now.modifiers == Qt::ShiftModifier)
            return tr("Shift+drag: select more points");
        if (now.modifiers == kCtrlShift)
            return tr("Ctrl+Shift+drag: deselect points");
        if (now.tool == Tool::add && now.pullsHandles)
            return tr("Click: add a point   Drag: pull its handles   Esc: end");
        if (now.tool == Tool::add)
            return tr("Click: add a point   Drag: place it   Esc: end");
        return tr("Double-click or Alt+click: add a point   Drag: select points   Ctrl+wheel: zoom");
    }
    static QString whileDragging(const DragKeys& keys) {
        if (keys.isSpaceHeld)
            return tr("Space: the knot goes along");
        if (keys.with(Qt::ControlModifier) && keys.with(Qt::AltModifier))
            return tr("Ctrl+Alt: the handle keeps its angle");
        if (keys.with(Qt::ControlModifier))
            return tr("Ctrl: steps of 15°");
        if (keys.with(Qt::AltModifier))
            return tr("Alt: the other handle stays");
        return tr(
            "Ctrl: steps of 15°   Ctrl+Alt: keep the angle   Alt: leave the other handle   Space: carry the knot");
    }
};

} // namespace

QString hintText(const HintSituation& situation) {
    if (!situation.under.grip && situation.explains)
        return Hints::overMark();
    if (!situation.under.grip)
        return situation.under.curve ? Hints::overCurve(situation) : Hints::overNothing(situation);
    switch (situation.under.grip->id.kind) {
    case GripKind::point:
        return Hints::overPoint(situation);
    case GripKind::inHandle:
    case GripKind::outHandle:
        return Hints::overHandle(situation.modifiers);
    case GripKind::startDerivative:
    case GripKind::endDerivative:
        return Hints::overArrow(situation.modifiers);
    case GripKind::inner:
    case GripKind::middle:
        break;
    }
    return Hints::overOther();
}

QString dragHintText(const DragKeys& keys) {
    return Hints::whileDragging(keys);
}

} // namespace kriva::ui
