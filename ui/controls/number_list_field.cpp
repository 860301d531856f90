#include "ui/controls/number_list_field.h"

#include "ui/base/language/number_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <utility>

namespace kriva::ui {
namespace {

/// Nothing where a part of the text is no number; an empty text holds none.
std::optional<std::vector<double>> numbersIn(const QString& text) {
    static const QRegularExpression separator(QStringLiteral("\\s*;\\s*|\\s+"));
    std::vector<double> numbers;
    if (text.trimmed().isEmpty())
        return numbers;
    for (const QString& part : text.trimmed().split(separator)) {
        const std::optional<double> number = parseNumber(part);
        if (!number)
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace

bool NumberListRange::contains(const std::vector<double>& numbers) const {
    return numbers.size() >= least && numbers.size() <= most &&
           std::ranges::all_of(numbers, [&](double number) { return each.contains(number); });
}

QString NumberListRange::text() const {
    const QString from = formatNumber(each.lowest);
    const QString to = formatNumber(each.highest);
    const int count = static_cast<int>(most);
    if (least == most)
        return NumberListField::tr("%n number(s) from %1 to %2, with semicolons between them.", nullptr, count)
            .arg(from, to);
    return NumberListField::tr("At most %n number(s) above %1 and below %2, with semicolons between them.", nullptr,
                               count)
        .arg(from, to);
}

NumberListField::NumberListField(QWidget* parent)
    : CheckedField(parent) {
    showHeld();
}

void NumberListField::setRange(const NumberListRange& range) {
    range_ = range;
    showVerdict();
}

void NumberListField::setNumbers(std::vector<double> numbers) {
    if (numbers == numbers_)
        return followHeld();
    numbers_ = std::move(numbers);
    showHeld();
}

bool NumberListField::accepts(const QString& text) const {
    const auto numbers = numbersIn(text);
    return numbers && range_.contains(*numbers);
}

QString NumberListField::heldText() const {
    QStringList texts;
    for (const double number : numbers_)
        texts.append(formatNumber(number));
    return texts.join(QStringLiteral("; "));
}

void NumberListField::apply(const QString& text) {
    std::vector<double> numbers = *numbersIn(text);
    if (numbers == numbers_)
        return;
    numbers_ = std::move(numbers);
    showHeld();
    Q_EMIT numbersCommitted(numbers_);
}

} // namespace kriva::ui
