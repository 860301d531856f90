#pragma once

#include <string>
#include <string_view>

namespace kriva {

/// A UTF-8 text as LaTeX sets it outside of formulas: what TeX takes for a command is escaped, signs of formulas are
/// set as such, control characters and broken UTF-8 become blanks.
[[nodiscard]] std::string latexText(std::string_view text);
/// The same within a formula.
[[nodiscard]] std::string latexFormula(std::string_view text);

/// Whether the text has Cyrillic letters, for which LaTeX needs the encoding T2A.
[[nodiscard]] bool hasCyrillic(std::string_view text);

} // namespace kriva
