#include "core/curve/limits.h"
#include "core/io/tables/points_reader.h"

#include <gtest/gtest.h>

#include <optional>

namespace kriva {
namespace {

std::optional<std::vector<Points>> readCurves(std::string_view text) {
    const auto read = readPointsTable(text);
    const auto* curves = std::get_if<std::vector<Points>>(&read);
    return curves ? std::optional(*curves) : std::nullopt;
}

/// Those of a table of one curve.
std::optional<Points> readPoints(std::string_view text) {
    const auto curves = readCurves(text);
    return curves && curves->size() == 1 ? std::optional(curves->front()) : std::nullopt;
}

TableError refusal(std::string_view text) {
    const auto read = readPointsTable(text);
    const TableError* error = std::get_if<TableError>(&read);
    EXPECT_TRUE(error) << text.substr(0, 100);
    return error ? *error : TableError{};
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string all;
    all.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i)
        all += text;
    return all;
}

TEST(PointsReader, takesEverySeparatorAndBothDecimalSigns) {
    const Points expected{{0.5, 1}, {-2, 0.25}};
    for (const char* text : {
             "0.5\t1\n-2\t0.25",
             "0,5\t1\n-2\t0,25",
             "0.5;1\n-2;0.25",
             "0,5 ; 1\n-2 ; 0,25",
             "0.5 1\n-2 0.25",
             "0,5 1\n-2   0,25",
             "0.5\t\t1\n-2 \t;\v 0.25",
             "0.5,1\n-2,0.25",
             "0.5, 1\n-2, 0.25",
             "\n  0.5\t1\t\r\n\r\n\u2212"
             "2\t2.5e-1\r\n",
             "\u00a0"
             "0.5 1\u2003\n\u0085\n-2 0.25\u3000",
         })
        EXPECT_EQ(readPoints(text), expected) << text;
}

TEST(PointsReader, refusesWhatIsNoTableOfTwoNumbers) {
    for (const char* text : {
             "",
             " \n \n",
             "1",
             "1\n2",
             "1\t2\t3",
             "1;;2",
             "1\t2\n3\t",
             "1\tnan",
             "1\t1e999",
             "1,5,2,5",
             "1.234,5\t1",
             "1 000\t2",
             "1\u00a0"
             "000\t2",
             "{\"format\": 1}",
             "1\t2\n\x80\t3",
         })
        EXPECT_EQ(readPoints(text), std::nullopt) << text;
}

TEST(PointsReader, passesOverALineThatNamesTheColumns) {
    for (const char* text : {"x\ty\n1\t2", "x,y\n1,2", "време;път\n1;2", "\nx y\n1 2"})
        EXPECT_EQ(readPoints(text), (Points{{1, 2}})) << text;
    for (const char* text : {"x\ty", "x\ty\nx\ty\n1\t2", "x\t\n1\t2", "1\ty\n1\t2"})
        EXPECT_EQ(readPoints(text), std::nullopt) << text;
}

TEST(PointsReader, readsTheCurvesThatKrivaWrites) {
    EXPECT_EQ(readCurves("curve,point,x,y\n0,0,0.5,1\n0,1,2,-3\n2,0,7,8\n"),
              (std::vector<Points>{{{0.5, 1}, {2, -3}}, {{7, 8}}}));
    EXPECT_EQ(readCurves("c;p;x;y\n0;0;0,5;1"), (std::vector<Points>{{{0.5, 1}}}));
    EXPECT_FALSE(readCurves("0;0;0.5;1")) << "four of what?";
    EXPECT_FALSE(readCurves("c,p,x,y\n0,0,1,1\n1,2"));
}

TEST(PointsReader, refusesACommaBetweenNumbersWhereItIsADecimalSignElsewhere) {
    EXPECT_EQ(readPoints("0,5\t1\n3,4"), std::nullopt);
    EXPECT_EQ(readPoints("3,4\n0,5 1"), std::nullopt);
}

TEST(PointsReader, refusesBothDecimalSignsInOneTableAtTheFirstOfTheOtherKind) {
    EXPECT_EQ(refusal("1,5;2\n1.5;2\n"), (TableError{TableProblem::mixedDecimals, 2, 1, "1.5"}));
    EXPECT_EQ(refusal("1;2\n1.5\t3\n4\t2,5\n"), (TableError{TableProblem::mixedDecimals, 3, 3, "2,5"}));
    EXPECT_EQ(refusal("1,5 2.5"), (TableError{TableProblem::mixedDecimals, 1, 5, "2.5"}));
    EXPECT_EQ(readPoints("1, 2.5\n3, 4"), (Points{{1, 2.5}, {3, 4}})) << "its commas are separators";
}

TEST(PointsReader, takesNumbersUpToTheLimitOfTheModel) {
    EXPECT_EQ(readPoints("1e9\t-1e9"), (Points{{limits::kNumber, -limits::kNumber}}));
    EXPECT_EQ(readPoints("1000000000.5\t0"), std::nullopt);
    EXPECT_EQ(readPoints("0\t-1000000000.5"), std::nullopt);
}

TEST(PointsReader, takesAsManyPointsAsACurveMayHave) {
    const std::string most = "x\ty\n" + repeated("1\t2\n", limits::kPointsInCurve);
    const auto points = readPoints(most);
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size(), limits::kPointsInCurve);
    constexpr int kLine = static_cast<int>(limits::kPointsInCurve) + 2;
    EXPECT_EQ(refusal(most + "\n1\t2\n"), (TableError{TableProblem::tooManyPointsInCurve, kLine + 1, 1, {}}));
    EXPECT_EQ(refusal(repeated("1,2\n", limits::kPointsInCurve + 1)),
              (TableError{TableProblem::tooManyPointsInCurve, kLine - 1, 1, {}}));
}

TEST(PointsReader, takesAsManyPointsAsASheetMayHave) {
    constexpr std::size_t kCurves = limits::kPointsInSheet / limits::kPointsInCurve;
    std::string most = "c\tp\tx\ty\n";
    for (std::size_t curve = 0; curve < kCurves; ++curve)
        most += repeated(std::string{static_cast<char>('0' + curve)} + "\t0\t1\t2\n", limits::kPointsInCurve);
    const auto curves = readCurves(most);
    ASSERT_TRUE(curves);
    EXPECT_EQ(curves->size(), kCurves);
    constexpr int kLine = static_cast<int>(limits::kPointsInSheet) + 2;
    EXPECT_EQ(refusal(most + "10\t0\t1\t2\n"), (TableError{TableProblem::tooManyPoints, kLine, 1, {}}));
    EXPECT_EQ(refusal(most + "9\t0\t1\t2\n").line, kLine);
}

TEST(PointsReader, saysWhereItIsRefusedAndWhy) {
    EXPECT_EQ(refusal(" \n\n"), TableError{});
    EXPECT_EQ(refusal("x\t1\n1\t2"), (TableError{TableProblem::noNumber, 1, 1, "x"}));
    EXPECT_EQ(refusal("1\t2\n\n3\tfour"), (TableError{TableProblem::noNumber, 3, 3, "four"}));
    EXPECT_EQ(refusal("1\t2\n  3\t4\t5"), (TableError{TableProblem::notTwoNumbers, 2, 7, {}}));
    EXPECT_EQ(refusal("1,2\n3,4\n5"), (TableError{TableProblem::notTwoNumbers, 3, 1, {}}));
    EXPECT_EQ(refusal("1\t2\n2e9\t0"), (TableError{TableProblem::outOfRange, 2, 1, "2e9"}));
    EXPECT_EQ(refusal("1\t2\n3;"), (TableError{TableProblem::noNumber, 2, 3, {}}));
}

TEST(PointsReader, keepsOnlyTheBeginningOfALongCell) {
    EXPECT_EQ(refusal(repeated("a", 20)).cell, repeated("a", 20));
    EXPECT_EQ(refusal(repeated("\u0431", 5000)).cell, repeated("\u0431", 20) + "…");
}

TEST(PointsReader, refusesWhatFillsAFileWithoutBeingATable) {
    constexpr std::size_t kBytes = 2 << 20;
    EXPECT_EQ(refusal(repeated("\n", kBytes)).problem, TableProblem::empty);
    EXPECT_EQ(refusal(repeated("\u2003", kBytes)).problem, TableProblem::empty);
    EXPECT_EQ(refusal(repeated(",", kBytes)), (TableError{TableProblem::noNumber, 1, 1, repeated(",", 20) + "…"}));
    EXPECT_EQ(refusal(repeated("1 ", kBytes)), (TableError{TableProblem::notTwoNumbers, 1, 5, {}}));
    EXPECT_EQ(refusal(repeated("1", kBytes) + " 2").problem, TableProblem::noNumber) << "beyond doubles";
    EXPECT_EQ(refusal(repeated("a ", kBytes) + "b\n1 2 3").line, 2) << "a heading, however long";
}

} // namespace
} // namespace kriva
