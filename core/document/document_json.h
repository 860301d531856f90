#pragma once

#include "core/document/document.h"

namespace kriva {

/// The version that this reader understands up to and this writer writes.
inline constexpr int kFormatVersion = 1;

/// Reads a document, refusing what format.md does not allow with the place of the first fault.
[[nodiscard]] std::variant<Document, FileError> readDocument(std::string_view text);

/// The document as UTF-8 JSON; readDocument gives it back bit for bit. `linesDownTo` 0 writes one line.
[[nodiscard]] std::string writeDocument(const Document& document, int linesDownTo = 5);

} // namespace kriva
