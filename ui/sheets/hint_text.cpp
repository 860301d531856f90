#include "ui/sheets/hint_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

class Hints {
    Q_DECLARE_TR_FUNCTIONS(Hint)
  public:
    static QString overGrip(const GripRef& grip, Qt::KeyboardModifiers modifiers) {
        if (grip.id.kind != GripKind::point)
            return tr("Drag: move the handle");
        if (modifiers.testFlag(Qt::AltModifier))
            return tr("Alt+click: remove the point");
        return tr("Drag: move the point, Ctrl: along an axis   Alt+click: remove it");
    }
    static QString overCurve() { return tr("Drag: mould the curve   Double-click: insert a point"); }
    static QString overNothing(Qt::KeyboardModifiers modifiers, Tool tool) {
        if (tool == Tool::add)
            return tr("Click: add a point   Esc: end");
        if (modifiers.testFlag(Qt::AltModifier))
            return tr("Alt+click: add a point");
        return tr("Double-click or Alt+click: add a point   Drag: select points   Ctrl+wheel: zoom");
    }
};

} // namespace

QString hintText(const Hit& under, Qt::KeyboardModifiers modifiers, Tool tool) {
    if (under.grip)
        return Hints::overGrip(*under.grip, modifiers);
    return under.curve ? Hints::overCurve() : Hints::overNothing(modifiers, tool);
}

} // namespace kriva::ui
