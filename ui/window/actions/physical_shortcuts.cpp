#include "ui/window/actions/physical_shortcuts.h"

#include "ui/canvas/key_gestures.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenuBar>

namespace kriva::ui {
namespace {

constexpr int kLastLatinKey = 0x7f;

[[nodiscard]] bool isShortcutElsewhere(const QKeyEvent& event) {
    return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0 && event.key() > kLastLatinKey &&
           event.key() < Qt::Key_Escape; // the first key that is no letter
}

} // namespace

PhysicalShortcuts::PhysicalShortcuts(QMainWindow& window)
    : QObject(&window)
    , window_(window) {
    qApp->installEventFilter(this);
}

bool PhysicalShortcuts::eventFilter(QObject* watched, QEvent* event) {
    // What comes here as a press was no shortcut to Qt.
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto* widget = qobject_cast<const QWidget*>(watched);
    const auto& press = *static_cast<const QKeyEvent*>(event);
    return widget && widget->window() == &window_ && isShortcutElsewhere(press) && carryOut(*watched, press);
}

bool PhysicalShortcuts::carryOut(QObject& receiver, const QKeyEvent& event) {
    const Qt::Key key = physicalKey(event);
    if (key == event.key())
        return false;
    // Fields have shortcuts of their own, which go before the window's.
    QKeyEvent asked(QEvent::ShortcutOverride, key, event.modifiers());
    asked.ignore();
    QApplication::sendEvent(&receiver, &asked);
    if (asked.isAccepted()) {
        QKeyEvent press(QEvent::KeyPress, key, event.modifiers());
        QApplication::sendEvent(&receiver, &press);
        return true;
    }
    const QKeySequence pressed(QKeyCombination(event.modifiers(), key));
    for (QAction* title : window_.menuBar()->actions()) {
        if (QKeySequence::mnemonic(title->text()) == pressed) {
            window_.menuBar()->setActiveAction(title);
            return true;
        }
    }
    for (QAction* action : window_.findChildren<QAction*>()) {
        if (action->isEnabled() && action->shortcuts().contains(pressed)) {
            action->trigger();
            return true;
        }
    }
    return false;
}

} // namespace kriva::ui
