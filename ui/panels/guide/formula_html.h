#pragma once

#include <QString>

namespace kriva::ui {

/// A page of the guide with its formulas as HTML: `$...$` within a line, `$$...$$` on a line of its own.
///
/// A letter is a variable, `_` and `^` lower and raise the next sign or group in braces, `-` is a minus, `'` a prime,
/// `~` a wide space;
/// `\max` is the name of a function, `\frac{a|b}` a fraction, `\binom{n|k}` a binomial coefficient, `\sum{a|b}` a sum
/// and `\int{a|b}` an integral from a to b. Within a line fractions have a slash, sums and integrals no bounds.
[[nodiscard]] QString withFormulas(const QString& page);

} // namespace kriva::ui
