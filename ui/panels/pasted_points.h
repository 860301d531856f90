#pragma once

#include "core/geometry/point.h"

#include <QString>

#include <optional>

namespace kriva::ui {

/// Points from a pasted table: two numbers in each line, with a decimal point or comma, between them a tab, a
/// semicolon, blanks or (where no number has a decimal comma) a comma. Nothing where a line reads otherwise, a number
/// is beyond the model's limits, or there are more lines than a curve has points.
[[nodiscard]] std::optional<Points> pastedPoints(const QString& text);

} // namespace kriva::ui
