#pragma once

#include <QString>

#include <optional>

namespace kriva::app {

/// The number of an option, which has a decimal point in every language; nothing where it is none from low to high.
[[nodiscard]] std::optional<double> optionNumber(const QString& text, double low, double high);

} // namespace kriva::app
