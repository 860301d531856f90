#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kriva {

/// A number that a person or a program wrote.
struct TypedNumber {
    double value = 0;
    char decimalSign = 0; ///< '.' or ',', 0 where there is none
};

/// The number of a text in UTF-8, whatever the language: decimal point and decimal comma mean the same, the minus may
/// be U+2212, a plus, an exponent and blanks around it are allowed. Nothing for everything else: group separators
/// ("1.234,5", "1 234"), words ("nan"), trailing text, numbers outside the range of doubles ("1e999"), and more than
/// 4,096 bytes.
[[nodiscard]] std::optional<TypedNumber> readTypedNumber(std::string_view text);

/// The fewest digits that readTypedNumber() reads back as the same double, with an ASCII minus. Powers of ten appear
/// only below 1e-5 and from 1e16 on ("1e-7").
[[nodiscard]] std::string writeTypedNumber(double value, std::string_view decimalSign);

} // namespace kriva
