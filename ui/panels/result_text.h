#pragma once

#include "core/document/results.h"

#include <QString>

namespace kriva::ui {

/// The name of a row: its caption, with its index where it has one ("Length 3").
[[nodiscard]] QString resultName(const Result& result);

/// Its value in the present language with so many significant digits; a dash where there is none.
[[nodiscard]] QString resultValue(const Result& result, int digits);
/// Any value likewise.
[[nodiscard]] QString valueText(const Result::Value& value, int digits);

} // namespace kriva::ui
