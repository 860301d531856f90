#include "ui/controls/checked_field.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

namespace kriva::ui {

CheckedField::CheckedField(QWidget* parent)
    : QLineEdit(parent) {
    connect(this, &QLineEdit::textChanged, this, &CheckedField::showVerdict);
}

bool CheckedField::commit() {
    if (!isEdited())
        return true;
    if (!accepts(text()))
        return false;
    apply(text());
    showHeld();
    return true;
}

void CheckedField::showHeld() {
    shown_ = heldText();
    if (text() != shown_)
        setText(shown_);
    if (!hasFocus())
        setCursorPosition(0); // its first digits tell more than its last ones
    showVerdict();
}

void CheckedField::followHeld() {
    if (isEdited() && hasFocus())
        showVerdict();
    else
        showHeld();
}

/// Marks a refused text and says why. An inherited palette is the mark of an accepted one.
void CheckedField::showVerdict() {
    const bool isRefused = !isAccepted();
    QPalette marked;
    if (isRefused) {
        const bool isDark = palette().color(QPalette::Window).lightness() < 128;
        marked.setColor(QPalette::Base, isDark ? QColor(0x5a, 0x1e, 0x1e) : QColor(0xff, 0xdc, 0xd8));
        marked.setColor(QPalette::Text, isDark ? QColor(0xff, 0xe6, 0xe3) : QColor(0x7a, 0x12, 0x0c));
    }
    setPalette(marked);
    setAccessibleDescription(isRefused ? refusal() : QString());
}

void CheckedField::tellRefusal() {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), refusal(), this);
}

bool CheckedField::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && !isAccepted()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), refusal(), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (isEdited() && key->key() == Qt::Key_Escape) {
            key->accept();
            return true;
        }
        // With nothing typed there is nothing of the field's to undo: the keys belong to the document.
        if (!isEdited() && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
            key->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void CheckedField::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        followHeld();
    else if (event->type() == QEvent::PaletteChange)
        showVerdict();
}

void CheckedField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!commit())
            return tellRefusal();
        selectAll();
        break;
    case Qt::Key_Escape:
        if (isEdited()) {
            showHeld();
            selectAll();
            return;
        }
        break;
    default:
        break;
    }
    QLineEdit::keyPressEvent(event);
}

void CheckedField::focusOutEvent(QFocusEvent* event) {
    // A context menu opens over the field and comes back to it.
    if (event->reason() != Qt::PopupFocusReason && !commit())
        showHeld();
    QLineEdit::focusOutEvent(event);
}

} // namespace kriva::ui
