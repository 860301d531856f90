#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/results.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

/// Reads a curve of the sheet `elevation`; refuses what format.md does not allow.
void readCurve(const JsonNode& node, ElevationCurve& curve);
/// Writes the keys that differ from their defaults.
void writeCurve(JsonWriter& json, const ElevationCurve& curve);

} // namespace kriva
