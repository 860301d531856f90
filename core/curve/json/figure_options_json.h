#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/figure/style/figure_options.h"

#include <span>

namespace kriva {

/// Reads the options that a view remembers; `layers` are those of its sheet.
[[nodiscard]] FigureFileOptions readFigureOptions(const JsonNode& node, std::span<const std::string_view> layers);
/// Writes an object with the keys that differ from their defaults.
void writeFigureOptions(JsonWriter& json, const FigureFileOptions& options);

} // namespace kriva
