#pragma once

#include "core/document/file_error.h"

#include <optional>

namespace kriva {

/// Why an XML text is beyond the limits of what is parsed: nested too deep, too many elements or attributes, or a
/// document type with an internal subset. Nothing where it is within; whether it is well-formed is not looked at.
/// Linear, without memory of its own, so that no hostile text ever reaches the parser.
[[nodiscard]] std::optional<FileError> xmlLimitError(std::string_view xml);

} // namespace kriva
