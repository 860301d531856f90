#include "core/curve/json/style_json.h"
#include "core/figure/labels.h"
#include "core/sheets/spline/spline.h"

namespace kriva {
namespace {

using Join = SplineKnot::Join;
using Rule = SplineCurve::Rule;

const std::initializer_list<std::pair<std::string_view, Join>> kJoins = {
    {"auto", Join::automatic}, {"symmetric", Join::symmetric}, {"smooth", Join::smooth}, {"corner", Join::corner}};

constexpr auto kRuleWords = [] {
    std::array<std::pair<std::string_view, Rule>, kRules.size()> words;
    for (std::size_t i = 0; i < kRules.size(); ++i)
        words[i] = {kRules[i].word, kRules[i].rule};
    return words;
}();

SplineKnot readKnot(const JsonNode& node) {
    const JsonObject object(node, {"at", "join", "in", "out"});
    SplineKnot knot;
    knot.at = object.require("at").point();
    if (const JsonNode* join = object.find("join"))
        knot.join = join->oneOf(kJoins);
    if (const JsonNode* in = object.find("in"))
        knot.in = in->point();
    if (const JsonNode* out = object.find("out"))
        knot.out = out->point();
    return knot;
}

/// Refuses a knot without a handle that a segment uses; parabolas use none.
void checkHandles(const JsonNode& knots, const SplineCurve& curve) {
    if (curve.degree == 2)
        return;
    knots.forEachElement([&, i = std::size_t(0)](const JsonNode& node) mutable {
        const SplineKnot& knot = curve.knots[i];
        if (!isAutomatic(knot) && hasSegmentBefore(curve, i) && !knot.in)
            node.refuse(FileProblem::missingKey, {}, {"in"});
        if (!isAutomatic(knot) && hasSegmentAfter(curve, i) && !knot.out)
            node.refuse(FileProblem::missingKey, {}, {"out"});
        ++i;
    });
}

/// With degrees that have no free control points any well-formed list is kept; a curve still being drawn does not
/// know yet which segments it will have.
void readInner(const JsonNode& node, SplineCurve& curve) {
    const std::size_t count = innerCount(curve.degree);
    std::optional<std::size_t> segments;
    if (count > 0 && !isIncomplete(curve))
        segments = segmentCount(curve);
    node.forEachIndexed(segments, [&](int segment, const JsonNode& points) {
        Points inner = points.points();
        if (count > 0 && inner.size() != count)
            points.refuse(FileProblem::wrongCount, {static_cast<double>(count)});
        curve.inner.emplace(segment, std::move(inner));
    });
}

void writeKnot(JsonWriter& json, const SplineKnot& knot) {
    json.beginObject().member("at", knot.at);
    if (!isAutomatic(knot))
        json.member("join", wordOf(knot.join, kJoins));
    if (knot.in)
        json.member("in", *knot.in);
    if (knot.out)
        json.member("out", *knot.out);
    json.endObject();
}

void writeInner(JsonWriter& json, const std::map<int, Points>& inner) {
    json.key("inner").beginObject();
    for (const auto& [segment, points] : inner)
        json.member(decimal(segment), points);
    json.endObject();
}

} // namespace

void readCurve(const JsonNode& node, SplineCurve& curve) {
    const JsonObject object(node, {"name", "degree", "rule", "closed", "startDerivative", "endDerivative", "knots",
                                   "inner", "style", "view"});
    if (const JsonNode* degree = object.find("degree"))
        curve.degree = degree->wholeNumber(limits::kSplineDegreeLow, limits::kSplineDegreeHigh);
    if (const JsonNode* rule = object.find("rule"))
        curve.rule = rule->oneOf(std::span(kRuleWords));
    if (const JsonNode* closed = object.find("closed"))
        curve.closed = closed->trueOrFalse();
    if (const JsonNode* start = object.find("startDerivative"))
        curve.startDerivative = start->vector();
    if (const JsonNode* end = object.find("endDerivative"))
        curve.endDerivative = end->vector();
    if (const JsonNode* knots = object.find("knots")) {
        curve.knots.reserve(knots->listSize(limits::kPointsInCurve));
        knots->forEachElement([&](const JsonNode& knot) { curve.knots.push_back(readKnot(knot)); });
        checkHandles(*knots, curve);
    }
    if (const JsonNode* inner = object.find("inner"))
        readInner(*inner, curve);
    readCommon(object, curve);
}

void writeCurve(JsonWriter& json, const SplineCurve& curve) {
    const SplineCurve defaults;
    json.beginObject();
    writeName(json, curve);
    if (curve.degree != defaults.degree)
        json.member("degree", curve.degree);
    if (curve.rule != defaults.rule)
        json.member("rule", wordOf(curve.rule, std::span(kRuleWords)));
    if (curve.closed)
        json.member("closed", true);
    if (curve.startDerivative)
        json.member("startDerivative", *curve.startDerivative);
    if (curve.endDerivative)
        json.member("endDerivative", *curve.endDerivative);
    json.key("knots").beginList();
    for (const SplineKnot& knot : curve.knots)
        writeKnot(json, knot);
    json.endList();
    if (!curve.inner.empty())
        writeInner(json, curve.inner);
    writeStyleAndView(json, curve);
    json.endObject();
}

} // namespace kriva
