#include "ui/controls/typing.h"

#include "ui/controls/checked_field.h"

#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QApplication>

namespace kriva::ui {
namespace {

/// A panel that floats is a window of its own, and a child all the same.
bool isIn(const QWidget& window, const QWidget* widget) {
    while (widget && widget != &window)
        widget = widget->parentWidget();
    return widget != nullptr;
}

/// The view whose cell is edited; null where the field stands by itself.
QAbstractItemView* viewOf(const QWidget& field) {
    QWidget* viewport = field.parentWidget();
    auto* view = qobject_cast<QAbstractItemView*>(viewport ? viewport->parentWidget() : nullptr);
    return view && view->viewport() == viewport ? view : nullptr;
}

} // namespace

void commitTyping(const QWidget& window) {
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    if (!field || !isIn(window, field))
        return;
    auto* checked = qobject_cast<CheckedField*>(field);
    if (checked && !checked->isAccepted())
        checked->tellRefusal();
    else if (const QAbstractItemView* view = viewOf(*field))
        Q_EMIT view->itemDelegate()->commitData(field);
    else if (checked)
        checked->commit();
}

} // namespace kriva::ui
