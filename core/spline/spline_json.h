#pragma once

#include "core/document/json/json_node.h"
#include "core/document/json/json_writer.h"
#include "core/spline/spline.h"

namespace kriva {

/// Reads a curve of the sheet `spline`; refuses what format.md does not allow.
void readCurve(const JsonNode& node, SplineCurve& curve);
/// Writes the keys that differ from their defaults.
void writeCurve(JsonWriter& json, const SplineCurve& curve);

} // namespace kriva
