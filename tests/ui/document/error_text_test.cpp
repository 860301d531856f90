#include "core/document/limit_check.h"
#include "core/document/report.h"
#include "core/io/json/document_json.h"
#include "core/io/open.h"
#include "core/io/svg/imported.h"
#include "tests/support/sheet_curves.h"
#include "ui/document/error_text.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

constexpr SheetIndex kElevation = kSheetOf<ElevationCurve>;
constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;

std::string repeated(std::string_view text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

std::string sentence(const FileError& error) {
    return errorText(error).toStdString();
}

/// What is said of a document, or of a figure with one inside.
std::string ofDocument(std::string_view bytes) {
    const auto read = readAnyDocument(bytes);
    const FileError* error = std::get_if<FileError>(&read);
    return error ? sentence(*error) : "not refused";
}

std::string ofMembers(std::string_view members) {
    return ofDocument(std::string(R"({"format":"kriva","version":1,)").append(members).append("}"));
}

std::string ofCurve(std::string_view sheet, std::string_view members) {
    return ofMembers(std::string(R"("sheets":{")").append(sheet).append(R"(":{"curves":[{)").append(members) + "}]}}");
}

std::string ofImport(std::string_view svg, SheetIndex sheet = kElevation) {
    const auto paths = readSvgPaths(svg);
    if (const FileError* error = std::get_if<FileError>(&paths))
        return sentence(*error);
    const auto curves = importedCurves(std::get<std::vector<ImportedPath>>(paths), sheet);
    const FileError* error = std::get_if<FileError>(&curves);
    return error ? sentence(*error) : "not refused";
}

std::string ofPathData(std::string_view data) {
    const auto paths = readPathsOfData(data);
    const FileError* error = std::get_if<FileError>(&paths);
    return error ? sentence(*error) : "not refused";
}

std::string ofEdit(const Curve& curve, const Sheet& sheet = {}) {
    const std::optional<FileError> error = limitErrorWith(sheet, {}, curve);
    return error ? sentence(*error) : "not refused";
}

TEST(ErrorText, ofADocumentNamesThePlaceInItsJson) {
    EXPECT_EQ(ofDocument("{"), "line 1, column 2: this is no JSON");
    EXPECT_EQ(ofDocument(repeated("[", 65)), "line 1, column 65: nested more than 64 deep");
    EXPECT_EQ(ofDocument(R"({"format":"other","version":1})"), "format: this is no document of Kriva");
    EXPECT_EQ(ofDocument(R"({"format":"kriva","version":2})"), "version: version 2 needs a newer Kriva");
    EXPECT_EQ(ofDocument("{}"), "the key “format” is missing");
    EXPECT_EQ(ofDocument("[]"), "expected an object");
    EXPECT_EQ(ofMembers(R"("<b>":1)"), "<b>: unknown key");
    EXPECT_EQ(ofMembers(R"("title":"","title":"")"), "title: the key stands here twice");
    EXPECT_EQ(ofMembers(R"("title":1)"), "title: expected a text");
    EXPECT_EQ(ofMembers(R"("active":1)"), "active: expected one of: elevation, subdivision, spline, combined");
    EXPECT_EQ(ofCurve("elevation", R"("points":1)"), "sheets.elevation.curves[0].points: expected a list");
    EXPECT_EQ(ofCurve("elevation", R"("points":[1])"),
              "sheets.elevation.curves[0].points[0]: expected two finite numbers");
    EXPECT_EQ(ofCurve("elevation", R"("points":[[1e10,0]])"),
              "sheets.elevation.curves[0].points[0]: expected a number from -1000000000 to 1000000000");
    EXPECT_EQ(ofCurve("elevation", R"("times":0.5)"),
              "sheets.elevation.curves[0].times: expected a whole number from 0 to 10000");
    EXPECT_EQ(ofCurve("elevation", R"("style":{"color":"red"})"),
              "sheets.elevation.curves[0].style.color: expected a colour like #0072b2");
    EXPECT_EQ(ofCurve("elevation", R"("view":{"shown":1})"),
              "sheets.elevation.curves[0].view.shown: expected true or false");
    EXPECT_EQ(ofCurve("elevation", R"("points":[)" + repeated("[0,0],", 201) + "[0,0]]"),
              "sheets.elevation.curves[0].points: more than 201 is too many");
    EXPECT_EQ(ofCurve("combined", R"("corrections":{"x":[0,0]})"),
              "sheets.combined.curves[0].corrections.x: no such index");
}

TEST(ErrorText, ofAFigureNamesTheLineOfTheDocumentInsideAndNoPathInIt) {
    const auto figure = [](std::string_view json) {
        return std::string("<svg>\n<metadata>\n<k:document xmlns:k='https://kriva.invalid/ns'>")
            .append(json)
            .append("</k:document></metadata></svg>");
    };
    EXPECT_EQ(ofDocument(figure("{")), "line 3, column 2, the document inside: this is no JSON");
    EXPECT_EQ(ofDocument(figure(R"({"format":"kriva","version":1,"titel":""})")),
              "line 3, column 2, the document inside: unknown key");
    EXPECT_EQ(ofDocument(figure(R"({"format":"kriva","version":1,"sheets":{"spline":{"curves":[)" +
                                repeated("{},", 1000) + "{}]}}}")),
              "line 3, column 2, the document inside: more than 1000 is too many");
    EXPECT_EQ(ofDocument("<svg/>"), "this figure has no document of Kriva inside");
}

TEST(ErrorText, ofAMissingFileIsTrueOfOneWhoseNameIsNoUtf8) {
    const ReadError missing{ReadFault::Missing};
    EXPECT_EQ(errorText(missing, QStringLiteral("a.svg")), QStringLiteral("a.svg: there is no such file"));
    EXPECT_EQ(errorText(missing, QStringLiteral("a\uFFFD.svg")),
              QStringLiteral("a\uFFFD.svg: there is no file of this name, and one whose name is no UTF-8 cannot be "
                             "opened"));
}

TEST(ErrorText, ofAnSvgNamesItsLineAndWhatIsWrongThere) {
    EXPECT_EQ(ofImport("<svg>\n<g>"), "line 2, column 4: this is no XML");
    EXPECT_EQ(ofImport("<svg/>\n<svg/>"),
              "line 2, column 1: there is something behind the end of the outermost element");
    EXPECT_EQ(ofImport("<svg>\n<g a='' a=''/></svg>"), "line 2, column 1: the attribute “a” stands here twice");
    EXPECT_EQ(ofImport("<svg>\n&nbsp;</svg>"), "line 2, column 1: the entity “nbsp” is unknown");
    EXPECT_EQ(ofImport("<?xml version='1.0' encoding='utf-8'?>\n<svg>\xE4</svg>"),
              "line 2, column 6: this is no UTF-8, which the file says that it is");
    EXPECT_EQ(ofImport("<?xml version='1.0' encoding='klingon'?>\n<svg>\xE4</svg>"),
              "line 2, column 6: the encoding “klingon” cannot be read");
    EXPECT_EQ(ofImport("<svg>\n\x01</svg>"), "line 2, column 1: “U+0001” is no character of XML");
    EXPECT_EQ(ofImport("<!DOCTYPE svg [<!ENTITY a 'b'>]><svg/>"),
              "line 1, column 1: the document type has declarations of its own");
    EXPECT_EQ(ofImport("<svg>" + repeated("<g>", 256)), "line 1, column 771: nested more than 256 deep");
    std::string attributes;
    for (int i = 0; i < 1001; ++i)
        attributes += " a" + std::string(static_cast<std::size_t>(i), 'b') + "=''";
    EXPECT_EQ(ofImport("<svg" + attributes + "/>"), "line 1, column 1: more than 1000 attributes are too many");
    EXPECT_EQ(ofImport("<svg><path d='X'/></svg>"), "line 1, column 7: the attribute “d” cannot be read");
    EXPECT_EQ(ofImport("<svg><path d='M0 0L1e10 1'/></svg>"),
              "line 1, column 7: the attribute “d” leads beyond the coordinates from -1000000000 to 1000000000");
    EXPECT_EQ(ofImport("<svg/>"), "there is no path to import");
    EXPECT_EQ(ofImport("<svg><g id='a'><use href='#a'/></g></svg>"),
              "line 1, column 17: uses of elements are nested more than 32 deep");
    EXPECT_EQ(
        ofImport("<svg><defs><path id='a' d='M0 0h1'/></defs>\n" + repeated("<use href='#a'/>", 10001) + "</svg>"),
        "line 2, column 160002: more than 10000 uses of elements are too many");
}

TEST(ErrorText, ofAnImportNamesTheCurveAndTheLimit) {
    EXPECT_EQ(ofImport("<svg><path d='M0 0h1'/><path d='M0 0" + repeated("L1 1L0 0", 150) + "'/></svg>"),
              "curve 2: this curve takes at most 201 points, and would have 301");
    EXPECT_EQ(ofImport("<svg xmlns:inkscape='i'><path inkscape:label='Leaf' d='M0 0" + repeated("L1 1L0 0", 150) +
                       "'/></svg>"),
              "curve 1, “Leaf”: this curve takes at most 201 points, and would have 301");
    EXPECT_EQ(ofImport("<svg><path d='" + repeated("M0 0h1", 1001) + "'/></svg>", kSpline),
              "a sheet takes at most 1000 curves, and these are 1001");
    EXPECT_EQ(ofPathData("M0 0L"), "line 1, column 6: this is no path data");
    EXPECT_EQ(ofPathData("M0 0" + repeated("h1", 1'000'001)), "a sheet takes at most 1000000 points");
}

TEST(ErrorText, ofAnEditNamesTheLimitAndNoPlace) {
    CombinedCurve wave;
    for (int i = 0; i < 300; ++i)
        wave.points.push_back({static_cast<double>(i), 0});
    wave.method = CombinedCurve::Method::interpolation;
    EXPECT_EQ(ofEdit(Curve(wave)), "interpolation takes at most 201 points in a monotone run, and one has 300");
    ElevationCurve elevation;
    elevation.points.assign(202, {1, 2});
    EXPECT_EQ(ofEdit(Curve(elevation)), "this curve takes at most 201 points, and would have 202");
    elevation.points = {{0, 0}, {2e9, 0}};
    EXPECT_EQ(ofEdit(Curve(elevation)), "coordinates go from -1000000000 to 1000000000");
    elevation.points = {{0, 0}, {1, 0}};
    EXPECT_EQ(ofEdit(Curve(elevation), Sheet{std::vector<Curve>(1000, Curve(ElevationCurve())), {}}),
              "a sheet takes at most 1000 curves, and these are 1001");
    elevation.times = 10'000;
    EXPECT_EQ(ofEdit(Curve(elevation), Sheet{std::vector<Curve>(200, Curve(elevation)), {}}),
              "a sheet takes at most 2000000 points of elevated curves and of pieces");
}

TEST(ErrorText, ofAReportNamesTheSheetAndTheLimit) {
    SplineCurve spline;
    spline.knots.resize(20'002);
    for (std::size_t i = 0; i < spline.knots.size(); ++i)
        spline.knots[i].at = {static_cast<double>(i), 0};
    Document document;
    document.sheets[kSpline].curves = test::curves({spline});
    const std::optional<FileError> error = reportLimitError(document, {});
    ASSERT_TRUE(error);
    EXPECT_EQ(sentence(*error),
              "sheets.spline.curves: a report takes at most 20000 segments of a sheet, and these are 20001");
}

TEST(ErrorText, isShortHoweverLongANameIs) {
    const std::string name(100'000, 'n');
    EXPECT_LT(ofImport("<svg " + name + "='' " + name + "=''/>").size(), 300u);
    EXPECT_LT(ofImport("<svg>&" + name + ";</svg>").size(), 300u);
}

} // namespace
} // namespace kriva::ui
