#include "core/io/svg/paths/visibility.h"

#include <algorithm>
#include <array>
#include <string>

namespace kriva {

bool isDrawnElsewhere(std::string_view name) {
    constexpr std::array<std::string_view, 8> kNames{"defs",   "symbol",  "clipPath", "mask",
                                                     "marker", "pattern", "metadata", "glyph"};
    return std::ranges::find(kNames, name) != kNames.end();
}

bool isDisplayed(const pugi::xml_node& element) {
    if (element.attribute("display").value() == std::string_view("none"))
        return false;
    std::string style = element.attribute("style").value();
    std::erase_if(style, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
    return style.find("display:none") == std::string::npos;
}

} // namespace kriva
