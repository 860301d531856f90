#pragma once

#include "core/curve/file_error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kriva {

/// The size of a reference to a character, "&#65;" or "&#x41;", at the beginning of a text; 0 where there is none.
[[nodiscard]] std::size_t characterReferenceSize(std::string_view text);

/// Why the bytes of an XML text are not read: one of them is not of UTF-8, which the text says that it is; it names an
/// encoding that Kriva does not read, and has more than ASCII; or there is a character that XML does not have. Where it
/// names none, or one of a byte for each character, bytes that are no UTF-8 are no reason. Linear.
[[nodiscard]] std::optional<FileError> xmlCharacterError(std::string_view xml);

/// The first byte that is not of UTF-8; npos where there is none.
[[nodiscard]] std::size_t firstBrokenByte(std::string_view text);

/// Whether some bytes of an XML text are no UTF-8, or a reference in it is to no character of XML, as "&#xD800;" is.
[[nodiscard]] bool hasBrokenCharacters(std::string_view xml);

/// The text with U+FFFD in place of each of these. Linear.
[[nodiscard]] std::string withoutBrokenCharacters(std::string_view xml);

/// Where a byte of withoutBrokenCharacters() stands in the text that it was made of. Linear.
[[nodiscard]] std::size_t byteBeforeRepair(std::string_view xml, std::size_t byte);

} // namespace kriva
