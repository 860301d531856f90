#pragma once

#include "ui/canvas/base/selection.h"

#include <QList>

class QAction;
class QPoint;

namespace kriva::ui {

class Actions;
class SheetTab;

/// The actions of the menus that apply to what lies under the pointer.
[[nodiscard]] QList<QAction*> contextActions(const Hit& under, const Actions& actions, const SheetTab& tab);

/// Opens the context menu of a tab's canvas.
void openContextMenu(SheetTab& tab, const Actions& actions, QPoint globalPosition, const Hit& under);

} // namespace kriva::ui
