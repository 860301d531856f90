#include "core/document/document_json.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

FileError errorOf(std::string_view text) {
    const auto read = readDocument(text);
    EXPECT_TRUE(std::holds_alternative<FileError>(read)) << text;
    return std::holds_alternative<FileError>(read) ? std::get<FileError>(read) : FileError{};
}

std::string withElevation(std::string_view curve) {
    return std::string(R"({"format":"kriva","version":1,"sheets":{"elevation":{"curves":[)")
        .append(curve)
        .append("]}}}");
}

TEST(ReadDocument, namesThePlaceOfAFault) {
    const FileError error = errorOf(withElevation(R"({"points":[[0,0],[1,"2"]]})"));
    EXPECT_EQ(error.problem, FileProblem::expectedTwoNumbers);
    EXPECT_EQ(error.place, "sheets.elevation.curves[0].points[1]");
}

TEST(ReadDocument, namesLineAndColumnWhereItIsNoJson) {
    const FileError error = errorOf("{\n  \"format\": kriva}");
    EXPECT_EQ(error.problem, FileProblem::notJson);
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 13);
}

TEST(ReadDocument, refusesUnknownAndRepeatedKeys) {
    EXPECT_EQ(errorOf(withElevation(R"({"point":[]})")).place, "sheets.elevation.curves[0].point");
    EXPECT_EQ(errorOf(withElevation(R"({"times":1,"times":1})")).problem, FileProblem::repeatedKey);
    EXPECT_EQ(errorOf(R"({"format":"kriva","version":1,"sheets":{},"sheets":{}})").problem, FileProblem::repeatedKey);
}

TEST(ReadDocument, takesWholeNumbersAsFormatMdSays) {
    EXPECT_TRUE(std::holds_alternative<Document>(readDocument(withElevation(R"({"times":5.0})"))));
    EXPECT_EQ(errorOf(withElevation(R"({"times":2.5})")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(errorOf(withElevation(R"({"times":true})")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(errorOf(withElevation(R"({"times":10001})")).problem, FileProblem::expectedWholeNumber);
}

TEST(ReadDocument, refusesForeignFormatsAndLaterVersions) {
    EXPECT_EQ(errorOf(R"({"version":1})").problem, FileProblem::missingKey);
    EXPECT_EQ(errorOf(R"({"format":"svg","version":1})").problem, FileProblem::foreignFormat);
    EXPECT_EQ(errorOf(R"({"format":"kriva","version":2})").problem, FileProblem::unknownVersion);
    EXPECT_EQ(errorOf("\xEF\xBB\xBF{}").problem, FileProblem::notJson);
}

TEST(ReadDocument, refusesNestingPast64) {
    EXPECT_EQ(errorOf(std::string(64, '[') + std::string(64, ']')).problem, FileProblem::expectedObject);
    EXPECT_EQ(errorOf(std::string(65, '[') + std::string(65, ']')).problem, FileProblem::nestedTooDeep);
}

TEST(ReadDocument, keepsNumbersWithinTheLimit) {
    EXPECT_TRUE(std::holds_alternative<Document>(readDocument(withElevation(R"({"points":[[1e9,-1e9]]})"))));
    EXPECT_EQ(errorOf(withElevation(R"({"points":[[1.0000001e9,0]]})")).problem, FileProblem::numberOutOfRange);
    EXPECT_EQ(errorOf(withElevation(R"({"points":[[1e999,0]]})")).problem, FileProblem::notJson);
}

TEST(WriteDocument, readsBackBitForBit) {
    Document document;
    document.title = "quotes \" and \\ and \x01 and крива";
    ElevationCurve curve;
    curve.points = {{-0.0, 0.1}, {1e-300, 1.0 / 3}, {123456789.123, 5e8}};
    curve.times = 97;
    curve.style.color = Color{1, 171, 205};
    curve.view.isShown = false;
    document.sheets[0].curves = {curve};
    document.sheets[0].view.layers["labels"] = false;
    const std::string text = writeDocument(document);
    const auto read = readDocument(text);
    ASSERT_TRUE(std::holds_alternative<Document>(read)) << text;
    EXPECT_EQ(std::get<Document>(read), document);
    EXPECT_TRUE(std::signbit(std::get<ElevationCurve>(std::get<Document>(read).sheets[0].curves[0]).points[0].x));
    EXPECT_EQ(writeDocument(std::get<Document>(read)), text);
}

TEST(SameContent, ignoresViewsAndTheActiveSheet) {
    Document a;
    a.sheets[0].curves = {ElevationCurve{}};
    Document b = a;
    b.sheets[0].view.activeCurve = 3;
    b.sheets[0].curves[0] = withView(b.sheets[0].curves[0], {false});
    EXPECT_TRUE(sameContent(a, b));
    b.sheets[0].curves[0] = renamed(b.sheets[0].curves[0], "other");
    EXPECT_FALSE(sameContent(a, b));
}

} // namespace
} // namespace kriva
