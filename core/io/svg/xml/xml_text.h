#pragma once

#include <string>
#include <string_view>

namespace kriva {

/// A text as it stands in an XML element or attribute, in well-formed UTF-8: control characters, what XML does not
/// allow and broken UTF-8 become U+FFFD.
[[nodiscard]] std::string xmlText(std::string_view text);

/// A JSON text for an XML element: what xmlText would replace is written as \uXXXX, so that it reads back the same.
/// The text must be well-formed UTF-8.
[[nodiscard]] std::string xmlJson(std::string_view json);

} // namespace kriva
