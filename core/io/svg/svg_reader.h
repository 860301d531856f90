#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"
#include "core/io/svg/drawn_sheet.h"

namespace kriva {

/// The document that Kriva wrote into the metadata of an SVG file, also after another program saved the file anew: its
/// place and its namespace count, not the prefix. Nothing outside of the text is ever opened.
[[nodiscard]] std::variant<Document, FileError> readDocumentFromSvg(std::string_view svg);

/// What the file tells of its drawing; nothing where it tells nothing, as frames do.
[[nodiscard]] std::optional<DrawnSheet> readDrawnSheetFromSvg(std::string_view svg);

} // namespace kriva
