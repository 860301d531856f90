#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"

namespace kriva {

/// Whether the first character, after a mark of the byte order and blanks, is a `<`, whatever the file is called.
[[nodiscard]] bool isXml(std::string_view bytes);

/// A document from the bytes of any file that can hold one: JSON, or an SVG file of Kriva's.
[[nodiscard]] std::variant<Document, FileError> readAnyDocument(std::string_view bytes);

} // namespace kriva
