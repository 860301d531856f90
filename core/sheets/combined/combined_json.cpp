#include "core/curve/json/style_json.h"
#include "core/figure/labels.h"
#include "core/sheets/combined/combined.h"

namespace kriva {
namespace {

using Basis = CombinedCurve::Basis;
using Method = CombinedCurve::Method;

std::string_view nameOf(Method method) {
    switch (method) {
    case Method::approximation:
        break;
    case Method::interpolation:
        return "interpolation";
    case Method::pairs:
        return "pairs";
    }
    return "approximation";
}

/// What depends on the points: only a complete curve promises it.
void checkPoints(const JsonObject& object, const CombinedCurve& curve) {
    if (const std::optional<FileError> error = pointLimitError(curve))
        object.require("points").refuse(error->problem, error->numbers);
}

void readCorrections(const JsonNode& node, CombinedCurve& curve) {
    std::optional<std::size_t> pairs;
    if (!isIncomplete(curve))
        pairs = curve.points.size() - 1;
    node.forEachIndexed(pairs,
                        [&](int pair, const JsonNode& middle) { curve.corrections.emplace(pair, middle.point()); });
}

} // namespace

std::string_view nameOf(Basis basis) {
    switch (basis) {
    case Basis::power:
        break;
    case Basis::newton:
        return "newton";
    case Basis::lagrange:
        return "lagrange";
    case Basis::chebyshev:
        return "chebyshev";
    }
    return "power";
}

void readCurve(const JsonNode& node, CombinedCurve& curve) {
    const JsonObject object(node, {"name", "points", "method", "degree", "basis", "corrections", "style", "view"});
    if (const JsonNode* points = object.find("points"))
        curve.points = points->points();
    if (const JsonNode* method = object.find("method"))
        curve.method = method->oneOf<Method>({{"approximation", Method::approximation},
                                              {"interpolation", Method::interpolation},
                                              {"pairs", Method::pairs}});
    if (const JsonNode* degree = object.find("degree"))
        curve.degree = degree->wholeNumber(limits::kFitDegreeLow, limits::kFitDegreeHigh);
    if (const JsonNode* basis = object.find("basis"))
        curve.basis = basis->oneOf<Basis>({{"power", Basis::power},
                                           {"newton", Basis::newton},
                                           {"lagrange", Basis::lagrange},
                                           {"chebyshev", Basis::chebyshev}});
    if (const JsonNode* corrections = object.find("corrections"))
        readCorrections(*corrections, curve);
    checkPoints(object, curve);
    readCommon(object, curve);
}

void writeCurve(JsonWriter& json, const CombinedCurve& curve) {
    const CombinedCurve usual;
    json.beginObject();
    writeName(json, curve);
    json.member("points", curve.points);
    if (curve.method != usual.method)
        json.member("method", nameOf(curve.method));
    if (curve.degree != usual.degree)
        json.member("degree", curve.degree);
    if (curve.basis != usual.basis)
        json.member("basis", nameOf(curve.basis));
    if (!curve.corrections.empty()) {
        json.key("corrections").beginObject();
        for (const auto& [pair, middle] : curve.corrections)
            json.member(decimal(pair), middle);
        json.endObject();
    }
    writeStyleAndView(json, curve);
    json.endObject();
}

} // namespace kriva
