#include "ui/editing/hints/hint.h"

#include "ui/base/language/number_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

constexpr int kDigits = 3; // of a measure that a person looks at once

} // namespace

QString Hint::text() const {
    const QString text = QCoreApplication::translate("Hint", source);
    return number ? text.arg(shownNumber(*number, kDigits)) : text;
}

} // namespace kriva::ui
