#include "core/io/numbers/typed_number.h"

#include "core/curve/text/utf8.h"

#include <charconv>
#include <string>

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

} // namespace kriva
