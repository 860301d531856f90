#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace kriva::ui {

/// "0,25; 0,5; 0,75" in the present language's decimal sign.
[[nodiscard]] QString blossomText(const std::vector<double>& arguments);

/// The numbers between semicolons or blanks; nothing where one of them is no number of the model.
[[nodiscard]] std::optional<std::vector<double>> blossomArguments(const QString& text);

} // namespace kriva::ui
