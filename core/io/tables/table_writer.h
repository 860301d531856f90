#pragma once

#include "core/curve/table.h"
#include "core/figure/text_source.h"

namespace kriva {

/// The table for a spreadsheet: UTF-8, fields divided by `separator`, quoted where they need it, lines ended by "\n".
/// Names follow the language; numbers never do, and read back bit for bit.
[[nodiscard]] std::string writeDelimited(const Table& table, const TextSource& texts, char separator = ',');

/// The table as a `tabular` of LaTeX with horizontal rules at the top, under the names and at the bottom: words and
/// numbers in the language, numbers with six significant digits and in math mode, the best of a column in bold.
[[nodiscard]] std::string writeLatex(const Table& table, const TextSource& texts);

} // namespace kriva
