#pragma once

#include "core/curve/file_error.h"

#include <optional>

namespace kriva {

/// Why an XML text is not parsed: it is not well-formed (XML 1.0, without namespaces), it says that it is UTF-8 and is
/// not, or in an encoding of which more than bytes beyond ASCII would be lost, it has a document type with an internal
/// subset, or it is nested too deep, with too many elements or attributes. Bytes that are no UTF-8 where it does not
/// say that it is, and references to no character, are no reason: see withoutBrokenCharacters(). Linear but for the
/// attributes of one tag, without memory of its own but for these, so that no hostile text ever reaches the parser.
[[nodiscard]] std::optional<FileError> xmlError(std::string_view xml);

} // namespace kriva
