#pragma once

#include "core/curve/file_error.h"

#include <pugixml.hpp>

#include <optional>
#include <string_view>

namespace kriva {

/// An SVG text and what it was parsed to. All names and values are well-formed UTF-8.
struct ParsedSvg {
    std::string_view text; ///< outlives this
    std::string repaired;  ///< what was parsed in its place, where it has broken characters
    pugi::xml_document xml;
};

/// Parses an SVG text: well-formed, within the limits of xmlError() and of files; bytes and references that are
/// no character become U+FFFD. Nothing where it did, else what is wrong. Nothing outside of the text is ever opened.
[[nodiscard]] std::optional<FileError> openSvg(std::string_view svg, ParsedSvg& parsed);

/// A problem of an element: its line and its column in the text.
[[nodiscard]] FileError errorAt(FileProblem problem, const ParsedSvg& parsed, const pugi::xml_node& element);

/// "kriva:document" is "kriva" and "document".
struct QualifiedName {
    std::string_view prefix;
    std::string_view local;
};
[[nodiscard]] QualifiedName nameOf(const pugi::xml_node& node);

} // namespace kriva
