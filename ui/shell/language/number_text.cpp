#include "ui/shell/language/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace kriva::ui {
namespace {

/// Holds the largest double in fixed notation with 17 decimals: a sign, 309 digits, a point, 17 digits.
using Digits = std::array<char, 330>;

constexpr double kSmallestFixed = 1e-5;
constexpr double kLargestFixed = 1e16;

[[nodiscard]] bool isDigit(QChar character) {
    return character >= u'0' && character <= u'9';
}

/// One character of a number as the C locale writes it; 0 if no number holds it.
[[nodiscard]] char plainCharacter(QChar character) {
    if (isDigit(character))
        return static_cast<char>(character.unicode());
    switch (character.unicode()) {
    case u'.':
    case u',':
        return '.';
    case u'-':
    case u'\u2212':
        return '-';
    case u'+':
        return '+';
    case u'e':
    case u'E':
        return 'e';
    default:
        return 0;
    }
}

[[nodiscard]] QString localized(std::string_view digits, const QLocale& locale) {
    QString text = QString::fromLatin1(digits.data(), static_cast<qsizetype>(digits.size()));
    return text.replace(u'.', locale.decimalPoint());
}

/// "1e-07" as people write it: "1e-7"; "1e+20" as "1e20".
[[nodiscard]] std::string withShortExponent(std::string_view digits) {
    const auto exponent = digits.find('e');
    std::string text(digits.substr(0, exponent + 1));
    if (digits[exponent + 1] == '-')
        text += '-';
    text += digits.substr(digits.find_first_not_of("+-0", exponent + 1));
    return text;
}

} // namespace

std::optional<double> parseNumber(QStringView text) {
    std::string plain;
    for (const QChar character : text.trimmed()) {
        const char c = plainCharacter(character);
        if (c == 0)
            return std::nullopt;
        plain += c;
    }
    // from_chars knows no leading plus; after it a second sign must not slip through.
    std::string_view number = plain;
    if (number.starts_with('+')) {
        number.remove_prefix(1);
        if (number.starts_with('-'))
            return std::nullopt;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size())
        return std::nullopt;
    return value;
}

QString formatNumber(double value, const QLocale& locale) {
    Digits digits;
    const double size = std::abs(value);
    const bool fixed = size == 0 || (size >= kSmallestFixed && size < kLargestFixed) || !std::isfinite(value);
    const auto format = fixed ? std::chars_format::fixed : std::chars_format::scientific;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, format).ptr;
    const std::string_view written(digits.data(), end);
    return localized(fixed ? std::string(written) : withShortExponent(written), locale);
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
