#pragma once

#include <pugixml.hpp>

#include <string_view>

namespace kriva {

/// Names of elements that are drawn where another one refers to them, or that draw no lines.
[[nodiscard]] bool isDrawnElsewhere(std::string_view name);

/// Whether an element does not say that it is not to be seen.
[[nodiscard]] bool isDisplayed(const pugi::xml_node& element);

} // namespace kriva
