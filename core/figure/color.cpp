#include "core/figure/color.h"

#include <charconv>

namespace kriva {

std::string hexOf(Color color) {
    constexpr char kHex[] = "0123456789abcdef";
    std::string text = "#";
    for (const int part : {color.red, color.green, color.blue}) {
        text += kHex[part / 16];
        text += kHex[part % 16];
    }
    return text;
}

std::optional<Color> colorFromHex(std::string_view text) {
    if (text.size() != 7 || text[0] != '#')
        return {};
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (error != std::errc() || end != text.data() + 7)
        return {};
    return Color{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 0xff),
                 static_cast<std::uint8_t>(value & 0xff)};
}

} // namespace kriva
