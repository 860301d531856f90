#pragma once

#include <optional>
#include <string_view>

namespace kriva {

/// The first character of a text that is not empty: its code point, nothing where the bytes are no UTF-8, and its
/// bytes (one where they are none). Overlong forms and surrogates are none, as RFC 3629 says.
struct Utf8Character {
    std::optional<char32_t> codePoint;
    std::string_view bytes;
};
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Calls visit(std::optional<char32_t> codePoint, std::string_view bytes) for each character.
template <class Visit>
void forEachCharacter(std::string_view text, Visit visit) {
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        visit(character.codePoint, character.bytes);
        text.remove_prefix(character.bytes.size());
    }
}

/// The text without blanks of any kind at both ends: all that Unicode calls White_Space.
[[nodiscard]] std::string_view withoutOuterBlanks(std::string_view text);

} // namespace kriva
