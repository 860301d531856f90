#include "core/curve/text/utf8.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace kriva {
namespace {

bool isBlank(char32_t c) {
    constexpr char32_t kOthers[] = {0x20, 0x85, 0xa0, 0x1680, 0x2028, 0x2029, 0x202f, 0x205f, 0x3000};
    const bool isControl = c >= 0x09 && c <= 0x0d;
    const bool isOfSomeWidth = c >= 0x2000 && c <= 0x200a;
    return isControl || isOfSomeWidth || std::ranges::find(kOthers, c) != std::end(kOthers);
}

bool isBlank(const Utf8Character& character) {
    return character.codePoint && isBlank(*character.codePoint);
}

/// Of a text that is not empty.
Utf8Character lastCharacter(std::string_view text) {
    constexpr std::size_t kLongest = 4; // bytes
    for (std::size_t size = std::min(kLongest, text.size()); size > 1; --size) {
        const Utf8Character character = firstCharacter(text.substr(text.size() - size));
        if (character.bytes.size() == size)
            return character;
    }
    return firstCharacter(text.substr(text.size() - 1));
}

} // namespace

Utf8Character firstCharacter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, text.substr(0, 1)};
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    const Utf8Character broken{std::nullopt, text.substr(0, 1)};
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size)
        return broken;
    char32_t codePoint = lead & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return broken;
        codePoint = codePoint << 6 | (byte(i) & 0x3fu);
    }
    constexpr char32_t kSmallest[] = {0x80, 0x800, 0x10000}; // of 2, 3 and 4 bytes
    if (codePoint >= 0xd800 && codePoint < 0xe000)
        return {std::nullopt, text.substr(0, size)};
    if (codePoint < kSmallest[size - 2] || codePoint > 0x10ffff)
        return broken;
    return {codePoint, text.substr(0, size)};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (!character.codePoint)
            return false;
        text.remove_prefix(character.bytes.size());
    }
    return true;
}

std::string asUtf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    forEachCharacter(text, [&](std::optional<char32_t> c, std::string_view bytes) {
        result += c && *c != 0 ? bytes : kReplacementCharacter;
    });
    return result;
}

std::string_view withoutOuterBlanks(std::string_view text) {
    while (!text.empty()) {
        const Utf8Character first = firstCharacter(text);
        if (!isBlank(first))
            break;
        text.remove_prefix(first.bytes.size());
    }
    while (!text.empty()) {
        const Utf8Character last = lastCharacter(text);
        if (!isBlank(last))
            break;
        text.remove_suffix(last.bytes.size());
    }
    return text;
}

bool isUnprintable(char32_t character) {
    constexpr std::array<char32_t, 3> kMarks{0x061c, 0x200e, 0x200f};
    const bool isControl = character < 0x20 || (character >= 0x7f && character < 0xa0);
    const bool endsLine = character == 0x2028 || character == 0x2029;
    const bool turnsLine = (character >= 0x202a && character <= 0x202e) || (character >= 0x2066 && character <= 0x2069);
    return isControl || endsLine || turnsLine || std::ranges::find(kMarks, character) != kMarks.end();
}

} // namespace kriva
