#pragma once

#include "core/document/document.h"

namespace kriva {

class JsonNode;

/// The version that this reader understands up to and this writer writes.
inline constexpr int kFormatVersion = 1;

/// The sheet that a value names; refuses any other value.
[[nodiscard]] SheetIndex readSheetName(const JsonNode& node);

/// Reads a document, refusing what format.md does not allow with the place of the first fault.
[[nodiscard]] std::variant<Document, FileError> readDocument(std::string_view text);

/// The document as UTF-8 JSON; readDocument gives it back bit for bit. `linesDownTo` 0 writes one line.
[[nodiscard]] std::string writeDocument(const Document& document, int linesDownTo = 5);

} // namespace kriva
