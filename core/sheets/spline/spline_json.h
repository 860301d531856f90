#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/sheets/spline/chain/spline.h"

namespace kriva {

/// Reads a curve of the sheet `spline`; refuses what format.md does not allow.
void readCurve(const JsonNode& node, SplineCurve& curve);
/// Writes the keys that differ from their defaults.
void writeCurve(JsonWriter& json, const SplineCurve& curve);

} // namespace kriva
