#include "ui/controls/slider_field.h"

#include "ui/base/language/number_text.h"
#include "ui/controls/focused_wheel.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

constexpr int kFieldWidth = 76; // px: room for six digits and a sign

QToolButton* stepButton(const QString& sign, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(sign);
    button->setAutoRaise(true);
    button->setAutoRepeat(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace

SliderField::SliderField(QWidget* parent)
    : QWidget(parent)
    , less_(stepButton(QStringLiteral("\u2212"), this))
    , slider_(new QSlider(Qt::Horizontal, this))
    , more_(stepButton(QStringLiteral("+"), this))
    , field_(new NumberField(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(less_);
    layout->addWidget(slider_, 1);
    layout->addWidget(more_);
    layout->addSpacing(4);
    layout->addWidget(field_);
    field_->setFixedWidth(kFieldWidth);
    slider_->setMinimumWidth(60);
    takeWheelWithFocusOnly(*slider_);
    setFocusProxy(slider_);
    connect(less_, &QToolButton::clicked, this, [this] { stepBy(-1); });
    connect(more_, &QToolButton::clicked, this, [this] { stepBy(1); });
    connect(slider_, &QSlider::sliderPressed, this, &SliderField::dragStarted);
    connect(slider_, &QSlider::sliderReleased, this, &SliderField::dragEnded);
    connect(slider_, &QSlider::valueChanged, this, &SliderField::takeSlider);
    connect(field_, &NumberField::valueCommitted, this, [this](double value) {
        setValue(value);
        Q_EMIT valueTyped(value);
    });
}

void SliderField::setSlider(double lowest, double highest, double step) {
    const QSignalBlocker blocker(slider_);
    lowest_ = lowest;
    step_ = step;
    slider_->setRange(0, static_cast<int>(std::lround((highest - lowest) / step)));
    slider_->setPageStep(std::max(1, slider_->maximum() / 10));
    field_->setStep(step);
    showState();
}

void SliderField::setRange(const NumberRange& range) {
    range_ = range;
    field_->setRange(range);
}

void SliderField::setValue(double value) {
    value_ = value;
    showState();
}

void SliderField::setAccessibleTexts(const QString& name, const QString& less, const QString& more) {
    slider_->setAccessibleName(name);
    field_->setAccessibleName(name);
    less_->setAccessibleName(less);
    less_->setToolTip(less);
    more_->setAccessibleName(more);
    more_->setToolTip(more);
}

void SliderField::showState() {
    const QSignalBlocker blocker(slider_);
    slider_->setValue(static_cast<int>(
        std::clamp<double>(std::round((value_ - lowest_) / step_), slider_->minimum(), slider_->maximum())));
    field_->setValue(value_);
    less_->setEnabled(range_.contains(stepped(value_, -step_)));
    more_->setEnabled(range_.contains(stepped(value_, step_)));
}

double SliderField::valueAt(int position) const {
    return stepped(lowest_, position * step_);
}

void SliderField::takeSlider(int position) {
    const double value = valueAt(position);
    if (!range_.contains(value)) {
        showState(); // an excluded end: back to where it was
        return;
    }
    value_ = value;
    showState();
    if (slider_->isSliderDown())
        Q_EMIT valueDragged(value);
    else
        Q_EMIT valueStepped(value);
}

void SliderField::stepBy(int steps) {
    const double value = stepped(value_, steps * step_);
    if (!range_.contains(value))
        return;
    setValue(value);
    Q_EMIT valueStepped(value);
}

} // namespace kriva::ui
