#include "ui/panels/controls/number_field.h"

#include "ui/shell/language/number_text.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace kriva::ui {

bool NumberRange::contains(double value) const {
    if (isWhole && value != std::floor(value))
        return false;
    return endsExcluded ? value > lowest && value < highest : value >= lowest && value <= highest;
}

NumberField::NumberField(QWidget* parent)
    : QLineEdit(parent) {
    setInputMethodHints(Qt::ImhFormattedNumbersOnly);
    connect(this, &QLineEdit::textChanged, this, &NumberField::showVerdict);
    retranslateUi();
}

void NumberField::setRange(const NumberRange& range) {
    range_ = range;
    showVerdict();
}

void NumberField::setStep(double step) {
    step_ = step;
}

void NumberField::setValue(double value) {
    const bool isHeld = value == value_ && std::signbit(value) == std::signbit(value_);
    if (isHeld && isEdited())
        return;
    value_ = value;
    showValue();
}

bool NumberField::commit() {
    if (!isEdited())
        return true;
    if (!isAccepted())
        return false;
    apply(*parseNumber(text()));
    return true;
}

void NumberField::apply(double value) {
    const bool isOther = value != value_;
    if (isOther)
        value_ = value;
    showValue();
    if (isOther)
        Q_EMIT valueCommitted(value);
}

void NumberField::stepBy(int steps) {
    if (isReadOnly())
        return;
    const double from = isAccepted() ? parseNumber(text()).value_or(value_) : value_;
    double to = stepped(from, steps * step_);
    if (!range_.endsExcluded)
        to = std::clamp(to, range_.lowest, range_.highest);
    if (range_.contains(to))
        apply(to);
}

void NumberField::retranslateUi() {
    if (isEdited())
        showVerdict();
    else
        showValue();
}

void NumberField::showValue() {
    shown_ = formatNumber(value_);
    if (text() != shown_)
        setText(shown_);
    if (!hasFocus())
        setCursorPosition(0); // its first digits tell more than its last ones
    showVerdict();
}

/// Marks a refused text and says why. An inherited palette is the mark of an accepted one.
void NumberField::showVerdict() {
    const bool isRefused = !isAccepted();
    QPalette marked;
    if (isRefused) {
        const bool isDark = palette().color(QPalette::Window).lightness() < 128;
        marked.setColor(QPalette::Base, isDark ? QColor(0x5a, 0x1e, 0x1e) : QColor(0xff, 0xdc, 0xd8));
        marked.setColor(QPalette::Text, isDark ? QColor(0xff, 0xe6, 0xe3) : QColor(0x7a, 0x12, 0x0c));
    }
    setPalette(marked);
    setAccessibleDescription(isRefused ? rangeText() : QString());
}

/// The held value is always accepted, typed text only as far as it means a number of the range.
bool NumberField::isAccepted() const {
    if (!isEdited())
        return true;
    const auto number = parseNumber(text());
    return number && range_.contains(*number);
}

QString NumberField::rangeText() const {
    const QString lowest = formatNumber(range_.lowest);
    const QString highest = formatNumber(range_.highest);
    if (range_.isWhole)
        return tr("A whole number from %1 to %2 is needed.").arg(lowest, highest);
    if (range_.endsExcluded)
        return tr("A number above %1 and below %2 is needed.").arg(lowest, highest);
    return tr("A number from %1 to %2 is needed.").arg(lowest, highest);
}

bool NumberField::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && !isAccepted()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), rangeText(), this);
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

void NumberField::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange)
        showVerdict();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!commit()) {
            QToolTip::showText(mapToGlobal(rect().bottomLeft()), rangeText(), this);
            return;
        }
        selectAll();
        break;
    case Qt::Key_Escape:
        if (isEdited()) {
            showValue();
            selectAll();
            return;
        }
        break;
    case Qt::Key_Up:
        return stepBy(1);
    case Qt::Key_Down:
        return stepBy(-1);
    default:
        break;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    // A context menu opens over the field and comes back to it.
    if (event->reason() != Qt::PopupFocusReason)
        commit();
    QLineEdit::focusOutEvent(event);
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (!hasFocus())
        return event->ignore();
    wheelAngle_ += event->angleDelta().y();
    const int steps = wheelAngle_ / QWheelEvent::DefaultDeltasPerStep;
    wheelAngle_ -= steps * QWheelEvent::DefaultDeltasPerStep;
    if (steps != 0)
        stepBy(steps);
    event->accept();
}

} // namespace kriva::ui
