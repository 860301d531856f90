#include "core/sheets/subdivision/subdivision.h"
#include "tests/core/sheets/subdivision/any_subdivision.h"
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
    return test::refusalOf(test::documentWith("subdivision", curve));
}

/// `[[0,0],[1,0],...]`
std::string pointList(int count) {
    std::string list = "[";
    for (int i = 0; i < count; ++i)
        list += i == 0 ? "[0,0]" : ",[1,0]";
    return list + "]";
}

std::string numberList(int count) {
    std::string list = "[";
    for (int i = 0; i < count; ++i)
        list += i == 0 ? "1" : ",1";
    return list + "]";
}

std::string curveWith(int points, std::string_view rest) {
    return R"({"points":)" + pointList(points) + "," + std::string(rest) + "}";
}

TEST(SubdivisionJson, fillsInWhatIsNotThere) {
    const auto curve = curveOf<SubdivisionCurve>(R"({"points":[[0,0],[1,2]]})");
    EXPECT_EQ(curve.multiplicity, (std::vector{1, 1}));
    EXPECT_EQ(curve.t, 0.5);
    EXPECT_EQ(curve.levels, 1);
    EXPECT_FALSE(curve.blossom);
    EXPECT_TRUE(curveOf<SubdivisionCurve>("{}").points.empty());
}

TEST(SubdivisionJson, readsEveryKey) {
    const auto curve = curveOf<SubdivisionCurve>(
        R"({"name":"a","points":[[0,0],[1,2],[3,4]],"multiplicity":[1,2.0,1],"t":0.25,"levels":3,"blossom":[-1,0.5,7]})");
    EXPECT_EQ(curve.name, "a");
    EXPECT_EQ(curve.multiplicity, (std::vector{1, 2, 1}));
    EXPECT_EQ(curve.t, 0.25);
    EXPECT_EQ(curve.levels, 3);
    EXPECT_EQ(curve.blossom, (std::vector<double>{-1, 0.5, 7}));
}

TEST(SubdivisionJson, writesOnlyWhatDiffersFromItsDefault) {
    SubdivisionCurve curve;
    curve.points = {{0, 0}, {1, 2}};
    curve.multiplicity = {1, 1};
    EXPECT_THAT(writeDocument(documentOfCurve(curve), 0),
                testing::HasSubstr(R"("curves": [{"name": "", "points": [[0, 0], [1, 2]]}])"));
}

TEST(SubdivisionJson, refusesMultiplicitiesThatDoNotFit) {
    EXPECT_EQ(refusalOf(curveWith(3, R"("multiplicity":[1,1])")).problem, FileProblem::wrongCount);
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":[1,1,1])")).place, "sheets.subdivision.curves[0].multiplicity");
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":[1,0])")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":[1,1.5])")).place,
              "sheets.subdivision.curves[0].multiplicity[1]");
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":2)")).problem, FileProblem::expectedList);
}

TEST(SubdivisionJson, refusesTOutsideItsOpenInterval) {
    for (const std::string_view t : {"0", "1", "-0.5", "1.5", "true", "\"0.5\"", "null"})
        EXPECT_EQ(refusalOf(curveWith(2, std::string("\"t\":").append(t))).place, "sheets.subdivision.curves[0].t");
    EXPECT_EQ(curveOf<SubdivisionCurve>(curveWith(2, R"("t":1e-300)")).t, 1e-300);
}

TEST(SubdivisionJson, refusesAWrongNumberOfBlossomArguments) {
    EXPECT_EQ(refusalOf(curveWith(3, R"("blossom":[0.5])")).numbers, std::vector<double>{2});
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":[1,2],"blossom":[0.5])")).problem, FileProblem::wrongCount);
    EXPECT_EQ(refusalOf(curveWith(2, R"("blossom":null)")).problem, FileProblem::expectedList);
    EXPECT_EQ(refusalOf(curveWith(2, R"("blossom":[1000000001])")).problem, FileProblem::numberOutOfRange);
}

TEST(SubdivisionJson, doesNotCheckCountsOfACurveStillBeingDrawn) {
    const auto curve =
        curveOf<SubdivisionCurve>(R"({"points":[[1,2]],"multiplicity":[3,1,1],"blossom":[0.25,0.5],"levels":16})");
    EXPECT_EQ(curve.multiplicity, std::vector{3});
    EXPECT_EQ(curve.blossom, (std::vector{0.25, 0.5}));
    EXPECT_EQ(curveOf<SubdivisionCurve>(R"({"points":[[1,2]],"multiplicity":[]})").multiplicity, std::vector{1});
}

TEST(SubdivisionJson, takes201ControlPointsAndNoMore) {
    EXPECT_EQ(curveOf<SubdivisionCurve>(curveWith(201, R"("levels":1)")).points.size(), 201u);
    EXPECT_EQ(refusalOf(curveWith(202, R"("levels":1)")).place, "sheets.subdivision.curves[0].points");
    EXPECT_EQ(curveOf<SubdivisionCurve>(curveWith(2, R"("multiplicity":[1,200])")).multiplicity[1], 200);
    EXPECT_EQ(refusalOf(curveWith(2, R"("multiplicity":[2,200])")).problem, FileProblem::tooMany);
}

TEST(SubdivisionJson, takesLevelsAsFarAsThePiecesAreWithinTheirLimit) {
    EXPECT_EQ(curveOf<SubdivisionCurve>(curveWith(30, R"("levels":16)")).levels, 16); // 1,966,080 points
    EXPECT_EQ(refusalOf(curveWith(31, R"("levels":16)")).numbers, (std::vector<double>{0, 15}));
    EXPECT_EQ(curveOf<SubdivisionCurve>(curveWith(2, R"("levels":0)")).levels, 0);
    EXPECT_EQ(refusalOf(curveWith(2, R"("levels":17)")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(refusalOf(curveWith(2, R"("levels":-1)")).place, "sheets.subdivision.curves[0].levels");
}

TEST(SubdivisionJson, takesTwoMillionPointsOfPiecesInASheetAndNoMore) {
    const std::string one = R"({"points":)" + pointList(125) + R"(,"levels":13})";  // 1,024,000 points
    const std::string rest = R"({"points":)" + pointList(61) + R"(,"levels":14})";  // 999,424: together too many
    const std::string less = R"({"points":)" + pointList(119) + R"(,"levels":13})"; // 974,848: together 1,998,848
    EXPECT_EQ(
        test::documentOf(test::documentWith("subdivision", one + "," + less)).sheets[test::kSubdivision].curves.size(),
        2u);
    EXPECT_EQ(refusalOf(one + "," + rest).place, "sheets.subdivision.curves");
}

TEST(SubdivisionJson, refusesWhatItDoesNotKnow) {
    EXPECT_EQ(refusalOf(curveWith(2, R"("times":1)")).problem, FileProblem::unknownKey);
    EXPECT_EQ(refusalOf(curveWith(2, R"("t":0.5,"t":0.5)")).problem, FileProblem::repeatedKey);
    EXPECT_EQ(refusalOf(R"({"points":)" + numberList(2) + "}").problem, FileProblem::expectedTwoNumbers);
}

RC_GTEST_PROP(SubdivisionJson, readsBackWhatItWrote, ()) {
    SubdivisionCurve curve = *test::anySubdivision();
    curve.name = "крива";
    const std::string text = writeDocument(documentOfCurve(curve));
    const auto read = readDocument(text);
    RC_ASSERT(std::holds_alternative<Document>(read));
    RC_ASSERT(std::get<Document>(read) == documentOfCurve(curve));
}

} // namespace
} // namespace kriva
