#include "ui/document/step_label.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

constexpr QChar kSeparator(0x1f); // the unit separator stands in no label

} // namespace

QString StepLabel::text() const {
    const QString text = QCoreApplication::translate("Step", source);
    return number ? text.arg(*number) : text;
}

QString stored(const StepLabel& label) {
    const QString source = QString::fromUtf8(label.source);
    return label.number ? source + kSeparator + QString::number(*label.number) : source;
}

QString resolvedStep(const QString& stored) {
    const QString text = QCoreApplication::translate("Step", stored.section(kSeparator, 0, 0).toUtf8().constData());
    const QString number = stored.section(kSeparator, 1, 1);
    return number.isEmpty() ? text : text.arg(number);
}

} // namespace kriva::ui
