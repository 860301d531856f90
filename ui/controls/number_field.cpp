#include "ui/controls/number_field.h"

#include "ui/base/language/number_text.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace kriva::ui {

bool NumberRange::contains(double value) const {
    if (isWhole && value != std::floor(value))
        return false;
    return endsExcluded ? value > lowest && value < highest : value >= lowest && value <= highest;
}

QString NumberRange::text() const {
    const QString from = formatNumber(lowest);
    const QString to = formatNumber(highest);
    if (isWhole)
        return NumberField::tr("A whole number from %1 to %2 is needed.").arg(from, to);
    if (endsExcluded)
        return NumberField::tr("A number above %1 and below %2 is needed.").arg(from, to);
    return NumberField::tr("A number from %1 to %2 is needed.").arg(from, to);
}

NumberField::NumberField(QWidget* parent)
    : CheckedField(parent) {
    setInputMethodHints(Qt::ImhFormattedNumbersOnly);
    showHeld();
}

void NumberField::setRange(const NumberRange& range) {
    range_ = range;
    showVerdict();
}

void NumberField::setStep(double step) {
    step_ = step;
}

void NumberField::setValue(double value) {
    const bool isNumber = !std::isnan(value);
    const bool isHeld = isNumber ? value == value_ && std::signbit(value) == std::signbit(value_) : std::isnan(value_);
    if (isHeld)
        return followHeld();
    value_ = value;
    showHeld();
}

bool NumberField::accepts(const QString& text) const {
    const auto number = parseNumber(text);
    return number && range_.contains(*number);
}

QString NumberField::heldText() const {
    return std::isnan(value_) ? QString() : formatNumber(value_);
}

void NumberField::apply(const QString& text) {
    take(*parseNumber(text));
}

void NumberField::take(double value) {
    if (value == value_)
        return showHeld();
    value_ = value;
    showHeld();
    Q_EMIT valueCommitted(value);
}

void NumberField::stepBy(int steps) {
    if (isReadOnly())
        return;
    const double from = isAccepted() ? parseNumber(text()).value_or(value_) : value_;
    if (std::isnan(from))
        return;
    double to = stepped(from, steps * step_);
    if (!range_.endsExcluded)
        to = std::clamp(to, range_.lowest, range_.highest);
    if (range_.contains(to))
        take(to);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Up)
        stepBy(1);
    else if (event->key() == Qt::Key_Down)
        stepBy(-1);
    else
        CheckedField::keyPressEvent(event);
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
