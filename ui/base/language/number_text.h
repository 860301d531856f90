#pragma once

#include <QLocale>
#include <QString>

#include <optional>

namespace kriva::ui {

/// The number that a person typed. Decimal point and decimal comma mean the same in every language, the minus may be
/// U+2212, an exponent and blanks around the number are allowed. nullopt for everything else: group separators
/// ("1.234,5", "1 234"), words ("nan"), trailing text, and numbers outside the range of doubles ("1e999").
[[nodiscard]] std::optional<double> parseNumber(QStringView text);

/// The fewest digits that read back as the same double, with the decimal sign of `locale`, an ASCII minus and no group
/// separators. Powers of ten appear only below 1e-5 and from 1e16 on ("1e-7").
[[nodiscard]] QString formatNumber(double value, const QLocale& locale = QLocale());

/// The number rounded to `decimals` (0 to 17) places after the decimal sign; what rounds to zero has no minus.
[[nodiscard]] QString formatNumber(double value, int decimals, const QLocale& locale = QLocale());

/// The same number set in type: with U+2212, the minus of formulas, in every language.
[[nodiscard]] QString withMinus(QString number);

/// Rounded to `digits` significant digits and set in type, for a person to read: no group separators.
[[nodiscard]] QString shownNumber(double value, int digits);

/// value + step as a person adds them: 0.1 and 0.2 give 0.3. Rounded to 15 significant digits of the larger of the two.
[[nodiscard]] double stepped(double value, double step);

} // namespace kriva::ui
