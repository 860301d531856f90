#include "core/io/plain_number.h"

#include <array>
#include <charconv>
#include <string_view>

namespace kriva {

std::string plainNumber(double value, int decimals) {
    std::array<char, 400> digits; // the largest double has 309 digits before the point
    const char* end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    if (text.find('.') != std::string_view::npos) {
        text = text.substr(0, text.find_last_not_of('0') + 1);
        if (text.ends_with('.'))
            text.remove_suffix(1);
    }
    return std::string(text == "-0" ? "0" : text);
}

} // namespace kriva
