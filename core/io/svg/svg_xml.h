#pragma once

#include "core/document/file_error.h"

#include <pugixml.hpp>

#include <optional>
#include <string_view>

namespace kriva {

/// Parses an SVG text, which outlives `xml`: within the limits of xmlLimitError() and of files. Nothing where it did,
/// else what is wrong. Nothing outside of the text is ever opened.
[[nodiscard]] std::optional<FileError> openSvg(std::string_view svg, pugi::xml_document& xml);

/// "kriva:document" is "kriva" and "document".
struct QualifiedName {
    std::string_view prefix;
    std::string_view local;
};
[[nodiscard]] QualifiedName nameOf(const pugi::xml_node& node);

} // namespace kriva
