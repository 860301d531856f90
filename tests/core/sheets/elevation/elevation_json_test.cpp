#include "core/curve/json/json_writer.h"
#include "core/sheets/elevation/elevation.h"
#include "tests/support/any_curve.h"
#include "tests/support/documents.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::curveOf;
using test::documentOfCurve;

FileError refusalOf(std::string_view curve) {
    return test::refusalOf(test::documentWith("elevation", curve));
}

std::string curveOfPoints(int count, int times) {
    ElevationCurve curve;
    curve.times = times;
    for (int i = 0; i < count; ++i)
        curve.points.push_back({static_cast<double>(i), 0});
    JsonWriter json(JsonWriter::Digits::shortest);
    writeCurve(json, curve);
    return std::move(json).take();
}

TEST(ElevationJson, fillsInWhatIsNotThere) {
    const auto curve = curveOf<ElevationCurve>("{}");
    EXPECT_EQ(curve, ElevationCurve{});
    EXPECT_EQ(curve.times, 0);
}

TEST(ElevationJson, writesOnlyWhatDiffersFromItsDefault) {
    ElevationCurve curve;
    curve.points = {{0, 0}, {1, 2}};
    EXPECT_THAT(writeDocument(documentOfCurve(curve), 0),
                testing::HasSubstr(R"("curves": [{"name": "", "points": [[0, 0], [1, 2]]}])"));
}

TEST(ElevationJson, takes201PointsAndNoMore) {
    EXPECT_EQ(curveOf<ElevationCurve>(curveOfPoints(201, 0)).points.size(), 201u);
    const FileError error = refusalOf(curveOfPoints(202, 0));
    EXPECT_EQ(error.problem, FileProblem::tooMany);
    EXPECT_EQ(error.place, "sheets.elevation.curves[0].points");
    EXPECT_EQ(error.numbers, std::vector<double>{201});
}

TEST(ElevationJson, takes10000ElevationsAndNoMore) {
    EXPECT_EQ(curveOf<ElevationCurve>(curveOfPoints(2, 10000)).times, 10000);
    EXPECT_EQ(refusalOf(R"({"times":10001})").numbers, (std::vector<double>{0, 10000}));
    EXPECT_EQ(refusalOf(R"({"times":-1})").place, "sheets.elevation.curves[0].times");
    for (const std::string_view times : {"2.5", "true", "\"2\"", "null", "[2]", "1e300"})
        EXPECT_EQ(refusalOf(std::string("{\"times\":").append(times).append("}")).problem,
                  FileProblem::expectedWholeNumber);
}

TEST(ElevationJson, takesTwoMillionElevatedPointsInASheetAndNoMore) {
    std::string curves;
    for (int i = 0; i < 199; ++i)
        curves += curveOfPoints(50, 10000) + ","; // 199 * 10,050 = 1,999,950
    EXPECT_EQ(test::documentOf(test::documentWith("elevation", curves + curveOfPoints(50, 0)))
                  .sheets[test::kElevation]
                  .curves.size(),
              200u);
    const FileError error = refusalOf(curves + curveOfPoints(51, 0));
    EXPECT_EQ(error.problem, FileProblem::tooManyDerivedPoints);
    EXPECT_EQ(error.place, "sheets.elevation.curves");
    EXPECT_EQ(error.numbers, std::vector<double>{2'000'000});
}

TEST(ElevationJson, refusesWhatItDoesNotKnow) {
    EXPECT_EQ(refusalOf(R"({"levels":1})").place, "sheets.elevation.curves[0].levels");
    EXPECT_EQ(refusalOf(R"({"name":"a","name":"a"})").problem, FileProblem::repeatedKey);
    EXPECT_EQ(refusalOf(R"({"name":5})").problem, FileProblem::expectedText);
    EXPECT_EQ(refusalOf("[]").problem, FileProblem::expectedObject);
}

RC_GTEST_PROP(ElevationJson, readsBackWhatItWrote, ()) {
    ElevationCurve curve;
    curve.points = *test::anyCurve(0, 8);
    curve.times = *rc::gen::inRange(0, 10001);
    const auto read = readDocument(writeDocument(documentOfCurve(curve)));
    RC_ASSERT(std::holds_alternative<Document>(read));
    RC_ASSERT(std::get<Document>(read) == documentOfCurve(curve));
}

} // namespace
} // namespace kriva
