#include "ui/sheets/hints/hint.h"

#include <QCoreApplication>
#include <QLocale>

namespace kriva::ui {
namespace {

constexpr int kDigits = 3; // of a measure that a person looks at once

} // namespace

QString Hint::text() const {
    const QString text = QCoreApplication::translate("Hint", source);
    return number ? text.arg(QLocale().toString(*number, 'g', kDigits)) : text;
}

} // namespace kriva::ui
