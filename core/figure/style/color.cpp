#include "core/figure/style/color.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kriva {
namespace {

/// Source: WCAG 2.1, "relative luminance".
double luminance(Color color) {
    const auto linear = [](std::uint8_t part) {
        const double c = part / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

} // namespace

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

double contrast(Color a, Color b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    constexpr double kFlare = 0.05; // of a screen in a lit room
    return (lighter + kFlare) / (darker + kFlare);
}

} // namespace kriva
