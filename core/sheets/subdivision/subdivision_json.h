#pragma once

#include "core/curve/json/json_node.h"
#include "core/curve/json/json_writer.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {

/// Reads a curve of the sheet `subdivision`; refuses what format.md does not allow. Of a curve that is still being
/// drawn the counts are not checked: multiplicities are cut or filled up to the points it has.
void readCurve(const JsonNode& node, SubdivisionCurve& curve);
/// Writes the keys that differ from their defaults.
void writeCurve(JsonWriter& json, const SubdivisionCurve& curve);

} // namespace kriva
