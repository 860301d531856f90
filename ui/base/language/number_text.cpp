#include "ui/base/language/number_text.h"

#include "core/io/numbers/typed_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace kriva::ui {
namespace {

/// Holds the largest double in fixed notation with 17 decimals: a sign, 309 digits, a point, 17 digits.
using Digits = std::array<char, 330>;

[[nodiscard]] QString localized(std::string_view digits, const QLocale& locale) {
    QString text = QString::fromLatin1(digits.data(), static_cast<qsizetype>(digits.size()));
    return text.replace(u'.', locale.decimalPoint());
}

} // namespace

std::optional<double> parseNumber(QStringView text) {
    const QByteArray bytes = text.toUtf8();
    const auto typed = readTypedNumber({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return typed ? std::optional(typed->value) : std::nullopt;
}

QString formatNumber(double value, const QLocale& locale) {
    return QString::fromStdString(writeTypedNumber(value, locale.decimalPoint().toStdString()));
}

QString formatNumber(double value, int decimals, const QLocale& locale) {
    Q_ASSERT(decimals >= 0 && decimals <= 17);
    Digits digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string_view written(digits.data(), end);
    if (written.starts_with('-') && written.find_first_not_of("-0.") == std::string_view::npos)
        written.remove_prefix(1);
    return localized(written, locale);
}

QString withMinus(QString number) {
    return number.replace(u'-', u'\u2212');
}

QString shownNumber(double value, int digits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return withMinus(locale.toString(value, 'g', digits));
}

double stepped(double value, double step) {
    const double sum = value + step;
    const double larger = std::max(std::abs(value), std::abs(step));
    if (larger == 0 || !std::isfinite(sum))
        return sum;
    // 15 significant digits survive any decimal that a double can tell apart (DBL_DIG).
    const int decimals = 14 - static_cast<int>(std::floor(std::log10(larger)));
    if (decimals < 0 || decimals > 300)
        return sum;
    Digits digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), sum, std::chars_format::fixed, decimals).ptr;
    double rounded = sum;
    std::from_chars(digits.data(), end, rounded);
    return rounded;
}

} // namespace kriva::ui
