#pragma once

#include "core/document/document.h"
#include "core/document/file_error.h"

namespace kriva {

/// A document from the bytes of any file that can hold one: JSON, or an SVG file of Kriva's. What begins with a `<`
/// is read as SVG, whatever the file is called.
[[nodiscard]] std::variant<Document, FileError> readAnyDocument(std::string_view bytes);

} // namespace kriva
