#pragma once

#include "core/curve/results.h"

#include <QString>

namespace kriva::ui {

/// The name of a row: its caption, with its index where it has one ("Length 3").
[[nodiscard]] QString resultName(const Result& result);

/// Its value in the present language with so many significant digits; a dash where there is none.
[[nodiscard]] QString resultValue(const Result& result, int digits);
/// Any value likewise.
[[nodiscard]] QString valueText(const Result::Value& value, int digits);

/// Significant digits of a deviation: how large it is, not what it is.
inline constexpr int kDeviationDigits = 4;

/// A letter with its index: "b₃", "bᵢ₋₁"; "b_m" where there is no such index in Unicode.
[[nodiscard]] QString indexed(const QString& letter, const QString& index);

} // namespace kriva::ui
