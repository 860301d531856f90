#include "ui/window/context_menu.h"

#include "ui/tabs/sheet_tab.h"
#include "ui/window/actions/actions.h"

#include <QMenu>

namespace kriva::ui {
namespace {

using Group = SheetAction::Group;

void addGroup(QList<QAction*>& all, const QList<QAction*>& group) {
    if (!all.isEmpty() && !group.isEmpty())
        all.append(nullptr);
    all += group;
}

} // namespace

QList<QAction*> contextActions(const Hit& under, const Actions& actions, const SheetTab& tab) {
    QList<QAction*> found;
    if (under.grip) {
        addGroup(found, tab.actions().of({Group::joins}));
        addGroup(found, tab.actions().of({Group::handles}));
        addGroup(found, {actions.insertPoint, actions.deleteSelected});
        addGroup(found, {actions.selectAll, actions.selectNone, actions.selectInverse, actions.fitSelection});
    } else if (under.curve) {
        addGroup(found, {actions.insertPoint});
        addGroup(found, tab.actions().of({Group::curve}));
        addGroup(found, {actions.reverseCurve, actions.duplicateCurve, actions.deleteCurve});
    } else {
        addGroup(found, {actions.editTool, actions.addTool});
        addGroup(found, {actions.newCurve, actions.clearCanvas, actions.selectAll});
        addGroup(found, {actions.fitAll, actions.zoomTo100, actions.grid, actions.axes});
    }
    return found;
}

void openContextMenu(SheetTab& tab, const Actions& actions, QPoint globalPosition, const Hit& under) {
    auto* menu = new QMenu(&tab.canvas());
    menu->setObjectName(QStringLiteral("contextMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (QAction* action : contextActions(under, actions, tab))
        action ? menu->addAction(action) : static_cast<void>(menu->addSeparator());
    // Not when it closes: what was chosen is carried out after that.
    QObject::connect(menu, &QObject::destroyed, &tab.input(), &SheetInput::endMenu);
    menu->popup(globalPosition);
}

} // namespace kriva::ui
