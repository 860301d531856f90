#include "app/commands/option_number.h"

#include <QLocale>

namespace kriva::app {

std::optional<double> optionNumber(const QString& text, double low, double high) {
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text, &isNumber);
    return isNumber && number >= low && number <= high ? std::optional(number) : std::nullopt;
}

} // namespace kriva::app
