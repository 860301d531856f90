#include "core/curve/json/json_writer.h"
#include "core/figure/labels.h"
#include "core/io/json/document_json.h"
#include "core/sheets/combined/combined.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

std::string documentWith(std::string_view curve) {
    return std::string(R"({"format":"kriva","version":1,"sheets":{"combined":{"curves":[)")
        .append(curve)
        .append("]}}}");
}

std::optional<CombinedCurve> readBack(std::string_view curve) {
    const auto read = readDocument(documentWith(curve));
    const Document* document = std::get_if<Document>(&read);
    if (!document)
        return {};
    const Sheet& sheet = document->sheets[*sheetNamed("combined")];
    return std::get<CombinedCurve>(sheet.curves.at(0));
}

FileError errorOf(std::string_view curve) {
    const auto read = readDocument(documentWith(curve));
    EXPECT_TRUE(std::holds_alternative<FileError>(read)) << curve;
    return std::holds_alternative<FileError>(read) ? std::get<FileError>(read) : FileError{};
}

/// `count` points in a row, x rising.
std::string row(int count) {
    std::string points = "[[0,0]";
    for (int i = 1; i < count; ++i)
        points.append(",[").append(decimal(i)).append(",0]");
    return points + "]";
}

TEST(CombinedJson, readsBackBitForBit) {
    CombinedCurve curve;
    curve.name = "aркуш";
    curve.points = {{-0.0, 0.1}, {1e-300, 1.0 / 3}, {123456789.123, 5e8}};
    curve.method = CombinedCurve::Method::pairs;
    curve.degree = 7;
    curve.basis = CombinedCurve::Basis::chebyshev;
    curve.corrections = {{0, {0.5, 1.5}}, {1, {1.0 / 7, -0.0}}};
    curve.style.width = 3;
    curve.view.isShown = false;
    Document document;
    document.sheets[*sheetNamed("combined")].curves = test::curves({curve});
    const std::string text = writeDocument(document);
    const auto read = readDocument(text);
    ASSERT_TRUE(std::holds_alternative<Document>(read)) << text;
    EXPECT_EQ(std::get<Document>(read), document);
    EXPECT_EQ(writeDocument(std::get<Document>(read)), text);
}

TEST(CombinedJson, hasTheDefaultsOfTheFormat) {
    EXPECT_EQ(readBack("{}"), CombinedCurve{});
    JsonWriter json(JsonWriter::Digits::shortest, 0);
    writeCurve(json, CombinedCurve{});
    EXPECT_EQ(std::move(json).take(), "{\"name\": \"\", \"points\": []}\n");
}

TEST(CombinedJson, namesThePlaceOfAFault) {
    const auto place = [](std::string_view curve) { return errorOf(curve).place; };
    EXPECT_EQ(place(R"({"method":"spline"})"), "sheets.combined.curves[0].method");
    EXPECT_EQ(place(R"({"degree":0})"), "sheets.combined.curves[0].degree");
    EXPECT_EQ(place(R"({"degree":10})"), "sheets.combined.curves[0].degree");
    EXPECT_EQ(place(R"({"basis":"bernstein"})"), "sheets.combined.curves[0].basis");
    EXPECT_EQ(place(R"({"points":[[0,0],[1,1]],"corrections":{"0":[1]}})"), "sheets.combined.curves[0].corrections.0");
    EXPECT_EQ(place(R"({"times":1})"), "sheets.combined.curves[0].times");
}

TEST(CombinedJson, takesCorrectionsOfPairsThatExist) {
    const std::string_view three = R"("points":[[0,0],[1,1],[2,0]])";
    const auto with = [&](std::string_view corrections) {
        return std::string("{").append(three).append(",\"corrections\":").append(corrections).append("}");
    };
    ASSERT_TRUE(readBack(with(R"({"1":[5,6]})")));
    EXPECT_EQ(readBack(with(R"({"1":[5,6]})"))->corrections.at(1), (Point{5, 6}));
    EXPECT_EQ(errorOf(with(R"({"2":[5,6]})")).problem, FileProblem::noSuchIndex);
    EXPECT_EQ(errorOf(with(R"({"-1":[5,6]})")).problem, FileProblem::noSuchIndex);
    EXPECT_EQ(errorOf(with(R"({"01":[5,6]})")).problem, FileProblem::noSuchIndex);
    EXPECT_EQ(errorOf(with(R"({"1":[5,6],"1":[5,6]})")).problem, FileProblem::repeatedKey);
    // Without points nothing is counted yet; with one there is no pair.
    EXPECT_TRUE(readBack(R"({"corrections":{"8":[1,2]}})"));
    EXPECT_FALSE(readBack(R"({"points":[[0,0]],"corrections":{"0":[1,2]}})"));
}

TEST(CombinedJson, limitsARunUnderInterpolationTo201Points) {
    const auto with = [](int count, std::string_view method) {
        return std::string(R"({"points":)").append(row(count)).append(R"(,"method":")").append(method).append("\"}");
    };
    EXPECT_TRUE(readBack(with(201, "interpolation")));
    EXPECT_EQ(errorOf(with(202, "interpolation")).place, "sheets.combined.curves[0].points");
    EXPECT_EQ(errorOf(with(202, "interpolation")).problem, FileProblem::tooManyPointsInRun);
    EXPECT_EQ(errorOf(with(202, "interpolation")).numbers, (std::vector<double>{201, 202}));
    EXPECT_TRUE(readBack(with(202, "approximation")));
}

} // namespace
} // namespace kriva
