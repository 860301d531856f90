#include "core/curve/text/utf8.h"
#include "core/document/report.h"
#include "core/io/json/document_json.h"
#include "core/io/open.h"
#include "core/io/svg/imported.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace kriva {
namespace {

constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;

std::string bytesOf(std::string_view name) {
    std::ifstream file(std::string(KRIVA_TEST_DATA "/found/").append(name), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_FALSE(bytes.empty()) << name;
    return bytes;
}

std::variant<std::vector<Curve>, FileError> imported(std::string_view name) {
    auto paths = readSvgPaths(bytesOf(name));
    if (FileError* error = std::get_if<FileError>(&paths))
        return std::move(*error);
    return importedCurves(std::get<std::vector<ImportedPath>>(paths), kSpline);
}

FileError refusalOf(std::string_view name) {
    const auto read = imported(name);
    const FileError* error = std::get_if<FileError>(&read);
    EXPECT_TRUE(error) << name;
    return error ? *error : FileError{};
}

FileError refusalOfDocument(std::string_view name) {
    const auto read = readAnyDocument(bytesOf(name));
    const FileError* error = std::get_if<FileError>(&read);
    EXPECT_TRUE(error) << name;
    return error ? *error : FileError{};
}

class ImportedName : public testing::TestWithParam<const char*> {};

TEST_P(ImportedName, thatIsNoUtf8MakesADocumentThatOpensAgain) {
    const auto read = imported(GetParam());
    ASSERT_TRUE(std::holds_alternative<std::vector<Curve>>(read));
    Document document;
    document.sheets[kSpline].curves = std::get<std::vector<Curve>>(read);
    ASSERT_EQ(document.sheets[kSpline].curves.size(), 1u);
    EXPECT_NE(nameOf(document.sheets[kSpline].curves[0]).find(kReplacementCharacter), std::string::npos);
    const std::string bytes = writeDocument(document);
    const auto opened = readDocument(bytes);
    ASSERT_TRUE(std::holds_alternative<Document>(opened)) << bytes;
    EXPECT_EQ(std::get<Document>(opened), document);
    EXPECT_EQ(writeDocument(std::get<Document>(opened)), bytes);
}

INSTANTIATE_TEST_SUITE_P(Found, ImportedName,
                         testing::Values("cp1251.svg", "badutf8-label.svg", "surrogate-label.svg"));

TEST(FoundInputs, twoRootsAreRefusedWhereTheSecondBegins) {
    const FileError error = refusalOf("two-roots.svg");
    EXPECT_EQ(error.problem, FileProblem::secondRoot);
    EXPECT_EQ(error.line, 1);
    EXPECT_EQ(error.column, 68);
}

TEST(FoundInputs, aFarPathBlamesItsData) {
    const FileError error = refusalOf("s_num06.svg");
    EXPECT_EQ(error.problem, FileProblem::farAttribute);
    EXPECT_EQ(error.words, std::vector<std::string>{"d"});
}

TEST(FoundInputs, aChainOf31UsesIsRead) {
    const auto read = imported("s_usechain31.svg");
    EXPECT_TRUE(std::holds_alternative<std::vector<Curve>>(read));
}

TEST(FoundInputs, tooManyPathsAreRefusedWithTheirNumberAndTheLimit) {
    const FileError error = refusalOf("many-1001.svg");
    EXPECT_EQ(error.problem, FileProblem::tooManyCurves);
    EXPECT_EQ(error.numbers, (std::vector<double>{1000, 1001}));
    EXPECT_EQ(error.place, "");
}

TEST(FoundInputs, aDeepDocumentIsRefusedWithTheLimit) {
    const FileError error = refusalOfDocument("j_depth65.kriva");
    EXPECT_EQ(error.problem, FileProblem::nestedTooDeep);
    EXPECT_EQ(error.numbers, std::vector<double>{64});
}

TEST(FoundInputs, markupInDocumentsIsAKeyLikeAnyOther) {
    EXPECT_EQ(refusalOfDocument("html-devzero.kriva").place, "<img src='/dev/zero'>");
    EXPECT_EQ(refusalOfDocument("html-passwd.kriva").problem, FileProblem::unknownKey);
}

TEST(FoundInputs, theReportEscapesWhatMovesACursorOrTurnsALine) {
    const auto document = readDocument(bytesOf("j_ctrlname.kriva"));
    ASSERT_TRUE(std::holds_alternative<Document>(document));
    const auto report = reportJson(std::get<Document>(document), "a\u202eb.kriva", kSpline);
    ASSERT_TRUE(std::holds_alternative<std::string>(report));
    const std::string& json = std::get<std::string>(report);
    EXPECT_NE(json.find(R"("document": "a\u202eb.kriva")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("name": "\u001b[31mred\u0007\u202eabc\u2066\u0085\u009b31m)"), std::string::npos) << json;
    forEachCharacter(json, [](std::optional<char32_t> c, std::string_view) {
        ASSERT_TRUE(c);
        EXPECT_TRUE(*c == '\n' || !isUnprintable(*c));
    });
}

} // namespace
} // namespace kriva
