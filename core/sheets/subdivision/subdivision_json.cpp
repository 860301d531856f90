#include "core/curve/json/style_json.h"
#include "core/sheets/subdivision/subdivision.h"

namespace kriva {
namespace {

std::vector<int> multiplicities(const JsonNode& node) {
    std::vector<int> read;
    read.reserve(node.listSize(limits::kPointsInCurve));
    node.forEachElement([&](const JsonNode& element) {
        read.push_back(element.wholeNumber(1, static_cast<int>(limits::kControlPoints)));
    });
    return read;
}

std::vector<double> arguments(const JsonNode& node) {
    std::vector<double> read;
    read.reserve(node.listSize(limits::kPointsInCurve));
    node.forEachElement([&](const JsonNode& element) { read.push_back(element.number()); });
    return read;
}

void checkCount(const JsonNode* node, std::size_t count, std::size_t expected) {
    if (node && count != expected)
        node->refuse(FileProblem::wrongCount, {static_cast<double>(expected)});
}

/// What depends on the number of points: only a complete curve promises it.
void checkCounts(const JsonObject& object, const SubdivisionCurve& curve) {
    const JsonNode* multiplicity = object.find("multiplicity");
    checkCount(multiplicity, curve.multiplicity.size(), curve.points.size());
    const std::size_t controlPoints = controlPointCount(curve);
    // Without multiplicities the list of points itself is within the limit.
    if (controlPoints > limits::kControlPoints)
        multiplicity->refuse(FileProblem::tooMany, {static_cast<double>(limits::kControlPoints)});
    if (curve.levels > mostLevels(controlPoints))
        object.require("levels").refuse(FileProblem::expectedWholeNumber,
                                        {0, static_cast<double>(mostLevels(controlPoints))});
    if (curve.blossom)
        checkCount(object.find("blossom"), curve.blossom->size(), controlPoints - 1);
}

} // namespace

void readCurve(const JsonNode& node, SubdivisionCurve& curve) {
    const JsonObject object(node, {"name", "points", "multiplicity", "t", "levels", "blossom", "style", "view"});
    if (const JsonNode* points = object.find("points"))
        curve.points = points->points(limits::kControlPoints);
    if (const JsonNode* multiplicity = object.find("multiplicity"))
        curve.multiplicity = multiplicities(*multiplicity);
    else
        curve.multiplicity.assign(curve.points.size(), 1);
    if (const JsonNode* t = object.find("t"))
        curve.t = t->numberBetween(0, 1);
    if (const JsonNode* levels = object.find("levels"))
        curve.levels = levels->wholeNumber(0, limits::kLevels);
    if (const JsonNode* blossom = object.find("blossom"))
        curve.blossom = arguments(*blossom);
    if (isIncomplete(curve))
        curve.multiplicity.resize(curve.points.size(), 1);
    else
        checkCounts(object, curve);
    readCommon(object, curve);
}

void writeCurve(JsonWriter& json, const SubdivisionCurve& curve) {
    json.beginObject();
    writeName(json, curve);
    json.member("points", curve.points);
    if (controlPointCount(curve) != curve.points.size())
        json.member("multiplicity", curve.multiplicity);
    if (curve.t != 0.5)
        json.member("t", curve.t);
    if (curve.levels != 1)
        json.member("levels", curve.levels);
    if (curve.blossom)
        json.member("blossom", *curve.blossom);
    writeStyleAndView(json, curve);
    json.endObject();
}

} // namespace kriva
