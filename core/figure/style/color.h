#pragma once

#include "core/figure/style/style.h"

#include <string>
#include <string_view>

namespace kriva {

/// "#0072b2"
[[nodiscard]] std::string hexOf(Color color);

/// Nothing where the text is no `#` with six hexadecimal digits.
[[nodiscard]] std::optional<Color> colorFromHex(std::string_view text);

/// How well one is seen on the other, from 1 to 21. Source: WCAG 2.1, "contrast ratio".
[[nodiscard]] double contrast(Color a, Color b);

} // namespace kriva
