#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kriva {

/// The first character of a text that is not empty: its code point, nothing where the bytes are no UTF-8, and its
/// bytes (one where they are none, but the three of a surrogate). Overlong forms and surrogates are none, as RFC 3629
/// says.
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

/// U+FFFD, which stands where there is no character.
inline constexpr std::string_view kReplacementCharacter = "\xEF\xBF\xBD";

/// Whether a text is well-formed UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

/// The text as a document may hold it: well-formed UTF-8 without NUL. What is no character becomes U+FFFD.
[[nodiscard]] std::string asUtf8(std::string_view text);

/// The text without blanks of any kind at both ends: all that Unicode calls White_Space.
[[nodiscard]] std::string_view withoutOuterBlanks(std::string_view text);

/// Whether a character moves the cursor of a terminal, breaks lines or turns them around: controls of both blocks, the
/// separators of lines and paragraphs, and the marks of Unicode's bidirectional algorithm.
[[nodiscard]] bool isUnprintable(char32_t character);

} // namespace kriva
