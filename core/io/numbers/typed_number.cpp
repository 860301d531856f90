#include "core/io/numbers/typed_number.h"

#include "core/curve/text/utf8.h"

#include <array>
#include <charconv>
#include <cmath>

namespace kriva {
namespace {

constexpr char32_t kMinusSign = 0x2212;

/// One character of a number as the C locale writes it; 0 if no number holds it.
char plainCharacter(char32_t character) {
    if (character >= U'0' && character <= U'9')
        return static_cast<char>(character);
    switch (character) {
    case U'.':
    case U',':
        return '.';
    case U'-':
    case kMinusSign:
        return '-';
    case U'+':
        return '+';
    case U'e':
    case U'E':
        return 'e';
    default:
        return 0;
    }
}

} // namespace

std::optional<TypedNumber> readTypedNumber(std::string_view text) {
    constexpr std::size_t kLongest = 4096; // bytes; all digits of the longest double are 1,075
    TypedNumber typed;
    std::string plain;
    text = withoutOuterBlanks(text);
    if (text.size() > kLongest)
        return {};
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        const char c = plainCharacter(character.codePoint.value_or(0));
        if (c == 0)
            return {};
        if (c == '.')
            typed.decimalSign = text.front();
        plain += c;
        text.remove_prefix(character.bytes.size());
    }
    // from_chars knows no leading plus; after it a second sign must not slip through.
    std::string_view number = plain;
    if (number.starts_with('+')) {
        number.remove_prefix(1);
        if (number.starts_with('-'))
            return {};
    }
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), typed.value);
    if (error != std::errc() || end != number.data() + number.size())
        return {};
    return typed;
}

std::string writeTypedNumber(double value, std::string_view decimalSign) {
    constexpr double kSmallestFixed = 1e-5;
    constexpr double kLargestFixed = 1e16;
    const double size = std::abs(value);
    const bool isFixed = size == 0 || (size >= kSmallestFixed && size < kLargestFixed) || !std::isfinite(value);
    const auto format = isFixed ? std::chars_format::fixed : std::chars_format::scientific;
    std::array<char, 32> digits; // 17 of them, a sign, a point and an exponent, or zeros in place of that
    std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value, format).ptr);
    if (const std::size_t exponent = text.find('e'); exponent != std::string::npos) {
        // "1e-07" as people write it: "1e-7"; "1e+20" as "1e20".
        const std::size_t from = exponent + (text[exponent + 1] == '-' ? 2 : 1);
        text.erase(from, text.find_first_not_of("+0", from) - from);
    }
    if (const std::size_t point = text.find('.'); point != std::string::npos)
        text.replace(point, 1, decimalSign);
    return text;
}

} // namespace kriva
