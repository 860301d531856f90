#include "ui/controls/focused_wheel.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace kriva::ui {
namespace {

class FocusedWheel : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus())
            return false;
        event->ignore(); // it goes on to what is around the field
        return true;
    }
};

} // namespace

void takeWheelWithFocusOnly(QWidget& field) {
    const bool turns =
        qobject_cast<QSlider*>(&field) || qobject_cast<QComboBox*>(&field) || qobject_cast<QAbstractSpinBox*>(&field);
    if (!turns)
        return;
    field.installEventFilter(new FocusedWheel(&field));
    if (field.focusPolicy() == Qt::WheelFocus)
        field.setFocusPolicy(Qt::StrongFocus); // or the wheel would give the focus first
}

} // namespace kriva::ui
