#include "core/curve/json/style_json.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

void readCurve(const JsonNode& node, ElevationCurve& curve) {
    const JsonObject object(node, {"name", "points", "times", "style", "view"});
    if (const JsonNode* points = object.find("points"))
        curve.points = points->points(limits::kControlPoints);
    if (const JsonNode* times = object.find("times"))
        curve.times = times->wholeNumber(0, limits::kElevations);
    readCommon(object, curve);
}

void writeCurve(JsonWriter& json, const ElevationCurve& curve) {
    json.beginObject();
    writeName(json, curve);
    json.member("points", curve.points);
    if (curve.times != 0)
        json.member("times", curve.times);
    writeStyleAndView(json, curve);
    json.endObject();
}

} // namespace kriva
