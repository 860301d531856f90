#include "core/io/json/document_json.h"
#include "tests/support/documents.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

using test::documentOf;
using test::refusalOf;

std::string withElevation(std::string_view curve) {
    return test::documentWith("elevation", curve);
}

/// A document with these members besides its format and version.
std::string withMembers(std::string_view members) {
    return std::string(R"({"format":"kriva","version":1,)").append(members).append("}");
}

std::string curves(int count, std::string_view curve) {
    std::string list;
    for (int i = 0; i < count; ++i)
        list.append(i == 0 ? "" : ",").append(curve);
    return list;
}

TEST(ReadDocument, namesThePlaceOfAFault) {
    const FileError error = refusalOf(withElevation(R"({"points":[[0,0],[1,"2"]]})"));
    EXPECT_EQ(error.problem, FileProblem::expectedTwoNumbers);
    EXPECT_EQ(error.place, "sheets.elevation.curves[0].points[1]");
}

TEST(ReadDocument, namesLineAndColumnWhereItIsNoJson) {
    const FileError error = refusalOf("{\n  \"format\": kriva}");
    EXPECT_EQ(error.problem, FileProblem::notJson);
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 13);
}

TEST(ReadDocument, refusesUnknownAndRepeatedKeys) {
    EXPECT_EQ(refusalOf(withElevation(R"({"point":[]})")).place, "sheets.elevation.curves[0].point");
    EXPECT_EQ(refusalOf(withElevation(R"({"times":1,"times":1})")).problem, FileProblem::repeatedKey);
    EXPECT_EQ(refusalOf(R"({"format":"kriva","version":1,"sheets":{},"sheets":{}})").problem, FileProblem::repeatedKey);
}

TEST(ReadDocument, takesWholeNumbersAsFormatMdSays) {
    EXPECT_EQ(test::curveOf<ElevationCurve>(R"({"times":5.0})").times, 5);
    EXPECT_EQ(refusalOf(withElevation(R"({"times":2.5})")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(refusalOf(withElevation(R"({"times":true})")).problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(refusalOf(withElevation(R"({"times":10001})")).problem, FileProblem::expectedWholeNumber);
}

TEST(ReadDocument, refusesForeignFormatsAndLaterVersions) {
    EXPECT_EQ(refusalOf(R"({"version":1})").problem, FileProblem::missingKey);
    EXPECT_EQ(refusalOf(R"({"format":"svg","version":1})").problem, FileProblem::foreignFormat);
    EXPECT_EQ(refusalOf(R"({"format":"kriva","version":2})").problem, FileProblem::unknownVersion);
    EXPECT_EQ(refusalOf("\xEF\xBB\xBF{}").problem, FileProblem::notJson);
}

TEST(ReadDocument, refusesNestingPast64) {
    EXPECT_EQ(refusalOf(std::string(64, '[') + std::string(64, ']')).problem, FileProblem::expectedObject);
    EXPECT_EQ(refusalOf(std::string(65, '[') + std::string(65, ']')).problem, FileProblem::nestedTooDeep);
}

TEST(ReadDocument, keepsNumbersWithinTheLimit) {
    EXPECT_EQ(test::curveOf<ElevationCurve>(R"({"points":[[1e9,-1e9]]})").points, (Points{{1e9, -1e9}}));
    EXPECT_EQ(refusalOf(withElevation(R"({"points":[[1.0000001e9,0]]})")).problem, FileProblem::numberOutOfRange);
    EXPECT_EQ(refusalOf(withElevation(R"({"points":[[1e999,0]]})")).problem, FileProblem::numberOutOfRange);
    EXPECT_EQ(refusalOf(withElevation(R"({"points":[[0,0],[NaN,0]]})")).problem, FileProblem::notJson);
}

TEST(ReadDocument, takesAnAbsentSheetForAnEmptyOne) {
    EXPECT_EQ(documentOf(R"({"version":1,"format":"kriva"})"), Document{});
    EXPECT_EQ(documentOf(withMembers(R"("sheets":{"elevation":{}})")), Document{});
    EXPECT_EQ(documentOf(withMembers(R"("sheets":{"subdivision":{"curves":[]}},"active":"elevation")")), Document{});
}

TEST(ReadDocument, readsTheActiveSheetAndTheTitle) {
    const Document document = documentOf(withMembers(R"("title":"\u0411\ud83d\ude42","active":"subdivision")"));
    EXPECT_EQ(document.title, "Б\U0001F642");
    EXPECT_EQ(sheetName(document.active), "subdivision");
}

TEST(ReadDocument, withoutAnActiveSheetOpensOnTheFirstThatHasACurve) {
    const auto activeOf = [](const std::string& members) { return sheetName(documentOf(withMembers(members)).active); };
    EXPECT_EQ(activeOf(R"("sheets":{"combined":{"curves":[{}]},"spline":{"curves":[{}]}})"), "spline");
    EXPECT_EQ(activeOf(R"("sheets":{"elevation":{"curves":[]},"combined":{"curves":[{}]}})"), "combined");
    EXPECT_EQ(activeOf(R"("sheets":{"elevation":{"curves":[{}]},"combined":{"curves":[{}]}})"), "elevation");
    EXPECT_EQ(activeOf(R"("sheets":{"combined":{"curves":[{}]}},"active":"elevation")"), "elevation");
    EXPECT_EQ(activeOf(R"("sheets":{})"), "elevation");
}

TEST(ReadDocument, refusesWhatIsNoDocument) {
    struct Case {
        std::string text;
        FileProblem problem;
        std::string place;
    };
    const std::vector<Case> cases{
        {"[]", FileProblem::expectedObject, ""},
        {"7", FileProblem::expectedObject, ""},
        {"{}", FileProblem::missingKey, ""},
        {R"({"format":"kriva"})", FileProblem::missingKey, ""},
        {R"({"format":7,"version":1})", FileProblem::expectedText, "format"},
        {R"({"format":"Kriva","version":1})", FileProblem::foreignFormat, "format"},
        {R"({"format":"kriva","version":0})", FileProblem::expectedWholeNumber, "version"},
        {R"({"format":"kriva","version":-1})", FileProblem::expectedWholeNumber, "version"},
        {R"({"format":"kriva","version":1.5})", FileProblem::expectedWholeNumber, "version"},
        {R"({"format":"kriva","version":"1"})", FileProblem::expectedWholeNumber, "version"},
        {R"({"format":"kriva","version":true})", FileProblem::expectedWholeNumber, "version"},
        {R"({"format":"kriva","version":2})", FileProblem::unknownVersion, "version"},
        {withMembers(R"("format":"kriva")"), FileProblem::repeatedKey, "format"},
        {withMembers(R"("titel":"")"), FileProblem::unknownKey, "titel"},
        {withMembers(R"("":"")"), FileProblem::unknownKey, R"("")"},
        {withMembers(R"("title":null)"), FileProblem::expectedText, "title"},
        {withMembers(R"("title":"\u0000")"), FileProblem::expectedText, "title"},
        {withMembers(R"("title\u0000":"")"), FileProblem::unknownKey, std::string("title\0", 6)},
        {withMembers(R"("active":"Spline")"), FileProblem::expectedOneOf, "active"},
        {withMembers(R"("active":0)"), FileProblem::expectedOneOf, "active"},
        {withMembers(R"("sheets":[])"), FileProblem::expectedObject, "sheets"},
        {withMembers(R"("sheets":{"splines":{}})"), FileProblem::unknownKey, "sheets.splines"},
        {withMembers(R"("sheets":{"elevation":{},"elevation":{}})"), FileProblem::repeatedKey, "sheets.elevation"},
        {withMembers(R"("sheets":{"elevation":[]})"), FileProblem::expectedObject, "sheets.elevation"},
        {withMembers(R"("sheets":{"elevation":{"curve":[]}})"), FileProblem::unknownKey, "sheets.elevation.curve"},
        {withMembers(R"("sheets":{"elevation":{"curves":{}}})"), FileProblem::expectedList, "sheets.elevation.curves"},
        {withElevation("null"), FileProblem::expectedObject, "sheets.elevation.curves[0]"},
        {withElevation(R"({},{"points":7})"), FileProblem::expectedList, "sheets.elevation.curves[1].points"},
    };
    for (const Case& bad : cases) {
        const FileError error = refusalOf(bad.text);
        EXPECT_EQ(error.problem, bad.problem) << bad.text;
        EXPECT_EQ(error.place, bad.place) << bad.text;
    }
}

TEST(ReadDocument, refusesStylesAndViewsItDoesNotKnow) {
    struct Case {
        std::string curve;
        FileProblem problem;
        std::string place;
    };
    const std::vector<Case> cases{
        {R"({"style":[]})", FileProblem::expectedObject, "style"},
        {R"({"style":{"colour":"#000000"}})", FileProblem::unknownKey, "style.colour"},
        {R"({"style":{"color":"#00000g"}})", FileProblem::expectedColor, "style.color"},
        {R"({"style":{"color":"red"}})", FileProblem::expectedColor, "style.color"},
        {R"({"style":{"color":0}})", FileProblem::expectedText, "style.color"},
        {R"({"style":{"width":0}})", FileProblem::numberOutOfRange, "style.width"},
        {R"({"style":{"width":20.5}})", FileProblem::numberOutOfRange, "style.width"},
        {R"({"style":{"dash":"wavy"}})", FileProblem::expectedOneOf, "style.dash"},
        {R"({"style":{"marker":"ring"}})", FileProblem::expectedOneOf, "style.marker"},
        {R"({"style":{"labels":0}})", FileProblem::expectedTrueOrFalse, "style.labels"},
        {R"({"view":{"shown":1}})", FileProblem::expectedTrueOrFalse, "view.shown"},
        {R"({"view":{"hidden":true}})", FileProblem::unknownKey, "view.hidden"},
    };
    for (const Case& bad : cases) {
        const FileError error = refusalOf(withElevation(bad.curve));
        EXPECT_EQ(error.problem, bad.problem) << bad.curve;
        EXPECT_EQ(error.place, "sheets.elevation.curves[0]." + bad.place) << bad.curve;
    }
}

TEST(ReadDocument, refusesViewsOfSheetsItDoesNotKnow) {
    const auto refusal = [](std::string_view view) {
        return refusalOf(withMembers(std::string(R"("sheets":{"elevation":{"view":)").append(view).append("}}")));
    };
    EXPECT_EQ(refusal(R"({"layers":{"lables":true}})").place, "sheets.elevation.view.layers.lables");
    EXPECT_EQ(refusal(R"({"layers":{"labels":true,"labels":true}})").problem, FileProblem::repeatedKey);
    EXPECT_EQ(refusal(R"({"layers":{"labels":0}})").problem, FileProblem::expectedTrueOrFalse);
    EXPECT_EQ(refusal(R"({"layers":{"pieces":true}})").problem, FileProblem::unknownKey); // a layer of another sheet
    EXPECT_EQ(refusal(R"({"activeCurve":1000})").problem, FileProblem::expectedWholeNumber);
    EXPECT_EQ(refusal(R"({"mmPerUnit":0})").problem, FileProblem::numberOutOfRange);
    EXPECT_EQ(refusal(R"({"stage":1})").problem, FileProblem::unknownKey); // of the moment
}

TEST(ReadDocument, refusesNumbersOfViewsThatAreOutOfRange) {
    struct Case {
        std::string view;
        FileProblem problem;
        std::string place;
    };
    std::string tooMany = "0.5";
    for (std::size_t i = 0; i < kFurtherParameters.mostNumbers; ++i)
        tooMany += ",0.5";
    const std::vector<Case> cases{
        {R"({"combScale":0})", FileProblem::numberOutOfRange, "combScale"},
        {R"({"combScale":100.5})", FileProblem::numberOutOfRange, "combScale"},
        {R"({"polylinePoints":1})", FileProblem::expectedWholeNumber, "polylinePoints"},
        {R"({"polylinePoints":101})", FileProblem::expectedWholeNumber, "polylinePoints"},
        {R"({"polylinePoints":2.5})", FileProblem::expectedWholeNumber, "polylinePoints"},
        {R"({"combScale":"1"})", FileProblem::expectedNumber, "combScale"},
        {R"({"parameters":0.5})", FileProblem::expectedList, "parameters"},
        {R"({"parameters":[0.5,1]})", FileProblem::numberOutOfOpenRange, "parameters[1]"},
        {R"({"parameters":[0]})", FileProblem::numberOutOfOpenRange, "parameters[0]"},
        {R"({"parameters":["t"]})", FileProblem::expectedNumber, "parameters[0]"},
        {R"({"parameters":[)" + tooMany + "]}", FileProblem::tooMany, "parameters"},
    };
    for (const Case& bad : cases) {
        const FileError error = refusalOf(withMembers(R"("sheets":{"spline":{"view":)" + bad.view + "}}"));
        EXPECT_EQ(error.problem, bad.problem) << bad.view;
        EXPECT_EQ(error.place, "sheets.spline.view." + bad.place) << bad.view;
    }
}

TEST(ReadDocument, takes1000CurvesInASheetAndNoMore) {
    EXPECT_EQ(documentOf(withElevation(curves(1000, "{}"))).sheets[test::kElevation].curves.size(), 1000u);
    const FileError error = refusalOf(withElevation(curves(1001, "{}")));
    EXPECT_EQ(error.problem, FileProblem::tooMany);
    EXPECT_EQ(error.place, "sheets.elevation.curves");
}

TEST(ReadDocument, takes64MebibytesAndNoMore) {
    std::string text = withElevation("{}");
    text.resize(limits::kFileBytes, ' ');
    EXPECT_EQ(documentOf(text).sheets[test::kElevation].curves.size(), 1u);
    text += ' ';
    const FileError error = refusalOf(text);
    EXPECT_EQ(error.problem, FileProblem::tooLarge);
    EXPECT_EQ(error.numbers, std::vector<double>{64.0 * 1024 * 1024});
}

TEST(WriteDocument, readsBackBitForBit) {
    Document document;
    document.title = "quotes \" and \\ and \x01 and крива";
    ElevationCurve curve;
    curve.points = {{-0.0, 0.1}, {1e-300, 1.0 / 3}, {123456789.123, 5e8}};
    curve.times = 97;
    curve.style.color = Color{1, 171, 205};
    curve.view.isShown = false;
    document.sheets[test::kElevation].curves = test::curves({curve});
    document.sheets[test::kElevation].view.layers["labels"] = false;
    SheetView& view = document.sheets[test::kSpline].view;
    view = withNumbers(withNumbers(view, kCombScale, {2.5}), kPolylinePoints, {12});
    document.sheets[test::kSubdivision].view = withNumbers({}, kFurtherParameters, {0.25, 1.0 / 3});
    const std::string text = writeDocument(document);
    const auto read = readDocument(text);
    ASSERT_TRUE(std::holds_alternative<Document>(read)) << text;
    EXPECT_EQ(std::get<Document>(read), document);
    EXPECT_TRUE(std::signbit(
        std::get<ElevationCurve>(std::get<Document>(read).sheets[test::kElevation].curves[0]).points[0].x));
    EXPECT_EQ(writeDocument(std::get<Document>(read)), text);
}

TEST(WriteDocument, writesOnlyTheSheetsThatHoldSomething) {
    EXPECT_EQ(writeDocument(Document{}, 0),
              "{\"format\": \"kriva\", \"version\": 1, \"title\": \"\", \"active\": \"elevation\", \"sheets\": {}}\n");
}

TEST(SameContent, ignoresViewsAndTheActiveSheet) {
    Document a;
    a.sheets[test::kElevation].curves = test::curves({ElevationCurve{}});
    Document b = a;
    b.sheets[test::kElevation].view.activeCurve = 3;
    b.sheets[test::kElevation].curves[0] = withView(b.sheets[test::kElevation].curves[0], {false});
    EXPECT_TRUE(sameContent(a, b));
    b.sheets[test::kElevation].curves[0] = renamed(b.sheets[test::kElevation].curves[0], "other");
    EXPECT_FALSE(sameContent(a, b));
}

} // namespace
} // namespace kriva
