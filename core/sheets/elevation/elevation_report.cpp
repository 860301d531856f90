#include "core/bezier/bounds.h"
#include "core/bezier/measures/arc_length.h"
#include "core/curve/json/json_writer.h"
#include "core/sheets/elevation/elevation.h"

namespace kriva {

void reportCurve(JsonWriter& json, const ElevationCurve& curve) {
    const Elevation elevation = elevate(curve);
    json.member("degree", static_cast<int>(curve.points.size()) - 1)
        .member("length", arcLength(curve.points))
        .member("bounds", tightBounds(curve.points));
    json.key("elevated")
        .beginObject()
        .member("times", curve.times)
        .member("degree", static_cast<int>(elevation.polygon.size()) - 1)
        .member("points", elevation.polygon)
        .member("gap", elevation.gap)
        .endObject();
}

std::optional<std::vector<Result>> results(const ElevationCurve& curve, WorkBudget& budget) {
    const Elevation elevation = elevate(curve);
    if (!budget.spend())
        return {};
    return {{{Caption::degree, "", static_cast<int>(curve.points.size()) - 1},
             {Caption::length, "", arcLength(curve.points)},
             {Caption::bounds, "", tightBounds(curve.points)},
             {translatable("Caption", "Degree after elevation"), "", static_cast<int>(elevation.polygon.size()) - 1},
             {Caption::gap, "", elevation.gap}}};
}

} // namespace kriva
