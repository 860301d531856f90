#include "ui/controls/labelled_form.h"

#include "ui/base/look/plain_label.h"
#include "ui/controls/focused_wheel.h"

namespace kriva::ui {

void LabelledForm::addField(QWidget* field) {
    auto* label = new PlainLabel(field->parentWidget());
    label->setBuddy(field);
    addRow(label, field);
    takeWheelWithFocusOnly(*field);
}

void LabelledForm::setLabel(QWidget* field, const QString& text) {
    static_cast<QLabel*>(labelForField(field))->setText(text);
    field->setAccessibleName(QString(text).remove(u'&'));
}

} // namespace kriva::ui
