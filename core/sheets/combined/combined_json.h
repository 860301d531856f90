#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/sheets/combined/combined_curve.h"

namespace kriva {

/// Reads a curve of the sheet `combined`; refuses what format.md does not allow.
void readCurve(const JsonNode& node, CombinedCurve& curve);
/// Writes the keys that differ from their defaults.
void writeCurve(JsonWriter& json, const CombinedCurve& curve);

/// The word of a basis in documents and reports: "chebyshev".
[[nodiscard]] std::string_view nameOf(CombinedCurve::Basis basis);

} // namespace kriva
