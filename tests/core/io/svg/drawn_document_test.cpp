#include "core/document/sheet_figure.h"
#include "core/io/svg/drawn_document.h"
#include "core/io/svg/drawn_sheet.h"
#include "core/io/svg/svg_reader.h"
#include "core/io/svg/svg_writer.h"
#include "tests/support/sheet_curves.h"
#include "tests/support/sheet_svg.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

constexpr SheetIndex kElevation = kSheetOf<ElevationCurve>;
constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;

const TextSource kFigureTexts{[](Caption) { return "Word"; }, [](double, int) { return std::string(); }, "en"};

/// A page of 10 millimetres for a unit, 6 of margin: (0, 0) is drawn at (6, 46), (4, 4) at (46, 6).
const DrawingOptions kTenTimes{{}, 10};

ElevationCurve cubic(Points points, std::string name) {
    ElevationCurve curve;
    curve.points = std::move(points);
    curve.name = std::move(name);
    curve.style.color = Color{200, 0, 0};
    return curve;
}

Document twoCubics() {
    Document document;
    document.sheets[kElevation].curves = test::curves(
        {cubic({{0, 0}, {1, 4}, {3, 4}, {4, 0}}, "Arch"), cubic({{0, 4}, {1, 0}, {3, 0}, {4, 4}}, "Bowl")});
    return document;
}

std::string figureOf(const Document& document, SheetIndex sheet, const SvgOptions& options = {}) {
    return test::sheetSvg(document, sheet, kFigureTexts, kTenTimes, options);
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// What stands between two texts, replaced.
std::string replacedBetween(std::string text, std::string_view before, std::string_view behind, std::string_view with) {
    const std::size_t from = text.find(before);
    EXPECT_NE(from, std::string::npos) << before;
    const std::size_t start = from + before.size();
    return text.replace(start, text.find(behind, start) - start, with);
}

/// The path with the id is drawn nowhere.
std::string withoutPath(const std::string& svg, const std::string& id) {
    return replacedBetween(svg, "<path id=\"" + id + "\" d=\"", "\"", "");
}

TEST(DrawnDocument, isNoneWhereTheLinesAreTheDocumentsOwn) {
    const Document document = twoCubics();
    for (const auto& decimals : {std::optional<int>(), std::optional(3), std::optional(0)})
        EXPECT_FALSE(drawnDocument(figureOf(document, kElevation, {{}, decimals}), document));
    EXPECT_FALSE(drawnDocument("<svg/>", document));
    EXPECT_FALSE(drawnDocument("{}", document));
}

TEST(DrawnDocument, isNoneWhereOthersWroteTheSameLines) {
    const Document document = twoCubics();
    const std::string svg = figureOf(document, kElevation);
    const std::string own = R"(d="M 6,46 C 16,6 36,6 46,46")";
    EXPECT_FALSE(drawnDocument(replaced(svg, own, R"(d="m 6,46 c 10,-40 30,-40.0004 40,0")"), document));
    EXPECT_FALSE(
        drawnDocument(replaced(svg, own, R"-(transform="translate(6 46)" d="M0 0C10-40 30-40 40 0")-"), document));
    EXPECT_TRUE(drawnDocument(replaced(svg, own, R"(d="m 6,46 c 10,-40 30,-40.002 40,0")"), document));
}

TEST(DrawnDocument, takesWhatChangedAndKeepsTheRest) {
    const Document document = twoCubics();
    const std::string svg =
        replaced(figureOf(document, kElevation), "M 6,46 C 16,6 36,6 46,46", "M 6,46 C 16,6 36,6 56,36");
    Document expected = document;
    std::get<ElevationCurve>(expected.sheets[kElevation].curves[0]).points.back() = {5, 1};
    EXPECT_EQ(drawnDocument(svg, document), expected) << "with its name and its colour";
}

TEST(DrawnDocument, losesCurvesThatWereDeleted) {
    Document document = twoCubics();
    document.sheets[kElevation].view.activeCurve = 1;
    Document expected = document;
    expected.sheets[kElevation].curves.pop_back();
    expected.sheets[kElevation].view.activeCurve = 0;
    EXPECT_EQ(drawnDocument(withoutPath(figureOf(document, kElevation), "curve-1"), document), expected);
}

TEST(DrawnDocument, keepsCurvesThatWereNotDrawn) {
    Document document = twoCubics();
    CurveView hidden;
    hidden.isShown = false;
    document.sheets[kElevation].curves[0] = withView(document.sheets[kElevation].curves[0], hidden);
    const std::string svg = figureOf(document, kElevation);
    EXPECT_FALSE(drawnDocument(svg, document));
    const auto drawn = drawnDocument(withoutPath(svg, "curve-1"), document);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->sheets[kElevation].curves, (std::vector<Curve>{document.sheets[kElevation].curves[0]}));
}

TEST(DrawnDocument, hasWhatWasDrawnBesides) {
    const Document document = twoCubics();
    const std::string svg =
        replaced(figureOf(document, kElevation), "<path id=\"curve-1\"",
                 R"(<path id="p7" inkscape:label="New" d="M 6,46 Q 16,6 26,46"/><path id="curve-1")");
    const auto drawn = drawnDocument(svg, document);
    ASSERT_TRUE(drawn);
    const std::vector<Curve>& curves = drawn->sheets[kElevation].curves;
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(curves[1], document.sheets[kElevation].curves[1]);
    EXPECT_EQ(nameOf(curves[2]), "New");
    EXPECT_EQ(std::get<ElevationCurve>(curves[2]).points, (Points{{0, 0}, {1, 4}, {2, 0}}));
}

TEST(DrawnDocument, dividesACurveThatWasBroken) {
    const Document document = twoCubics();
    const std::string svg =
        replaced(figureOf(document, kElevation), "M 6,46 C 16,6 36,6 46,46", "M 6,46 L 16,6 M 36,6 L 46,46");
    const auto drawn = drawnDocument(svg, document);
    ASSERT_TRUE(drawn);
    const std::vector<Curve>& curves = drawn->sheets[kElevation].curves;
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(std::get<ElevationCurve>(curves[0]).points, (Points{{0, 0}, {1, 4}}));
    EXPECT_EQ(std::get<ElevationCurve>(curves[1]).points, (Points{{3, 4}, {4, 0}}));
    EXPECT_EQ(nameOf(curves[1]), "Arch");
    EXPECT_EQ(styleOf(curves[1]), styleOf(document.sheets[kElevation].curves[0]));
}

TEST(DrawnDocument, takesTheChainOfASpline) {
    Document document;
    SplineCurve spline;
    spline.knots = {{{0, 0}, {}, {}, {}}, {{2, 4}, {}, {}, {}}, {{4, 0}, {}, {}, {}}};
    document.sheets[kSpline].curves = test::curves({spline});
    const std::string own = figureOf(document, kSpline);
    EXPECT_FALSE(drawnDocument(own, document));
    const std::string svg =
        replacedBetween(own, "<path id=\"curve-0\" d=\"", "\"", "M 6,46 C 6,26 16,6 26,6 C 36,6 46,26 46,46");
    const auto drawn = drawnDocument(svg, document);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->active, kSpline);
    const std::vector<SplineKnot>& knots = std::get<SplineCurve>(drawn->sheets[kSpline].curves[0]).knots;
    ASSERT_EQ(knots.size(), 3u);
    const auto at = [&](Point onPage) { return inDocument(*readDrawnSheetFromSvg(svg), onPage); };
    EXPECT_EQ(knots[1].at, at({26, 6}));
    EXPECT_EQ(knots[1].in, at({16, 6}));
    EXPECT_EQ(knots[1].out, at({36, 6}));
}

TEST(DrawnDocument, isNoneWhereTheFileDoesNotTellWhatItDraws) {
    const Document document = twoCubics();
    const std::string svg = replaced(figureOf(document, kElevation), "M 6,46 C", "M 6,40 C");
    ASSERT_TRUE(drawnDocument(svg, document));
    for (const std::string_view other :
         {R"({"sheet": "none", "curves": [0, 1], )", R"({"sheet": "elevation", "curves": [0, 2], )",
          R"({"sheet": "elevation", "curves": [0, -1], )", R"({"sheet": "elevation", "curves": [], )", "[", ""})
        EXPECT_FALSE(drawnDocument(replaced(svg, R"({"sheet": "elevation", "curves": [0, 1], )", other), document))
            << other;
    EXPECT_FALSE(drawnDocument(replaced(svg, R"("mmPerUnit": 10)", R"("mmPerUnit": 0)"), document));
    EXPECT_FALSE(drawnDocument(replaced(svg, "id=\"curve-0\" d=\"M", "id=\"curve-0\" d=\"N"), document));
}

TEST(DrawnDocument, isNoneBeyondTheLimitsOfTheSheet) {
    const Document document = twoCubics();
    std::string many = "M 6,46";
    for (int i = 0; i < 2000; ++i)
        many += i % 2 == 0 ? " L 46,6" : " L 6,46";
    const std::string svg = replaced(figureOf(document, kElevation), "M 6,46 C 16,6 36,6 46,46", many);
    EXPECT_FALSE(drawnDocument(svg, document));
}

TEST(DrawnSheet, comesBackBitForBit) {
    const DrawnSheet drawn{kSpline, {0, 3, 7}, 1.0 / 3, 6.1, {1e8 + 1.0 / 3, -0.0}, 11};
    const auto back = readDrawnSheet(writeDrawnSheet(drawn));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, drawn);
    EXPECT_TRUE(std::signbit(back->corner.y));
}

TEST(DrawnSheet, hasThePageOfTheDrawing) {
    Document document = twoCubics();
    for (Curve& curve : document.sheets[kElevation].curves)
        for (Point& p : std::get<ElevationCurve>(curve).points)
            p = {1e8 + 1e-7 * p.x, -1e8 + 1e-7 * p.y};
    const Drawing drawing = drawingOf(document, kElevation, kFigureTexts);
    const DrawnSheet drawn = drawnSheetOf(drawing, 3);
    EXPECT_EQ(drawn.curves, (std::vector{0, 1}));
    const Point far = pointAt(document.sheets[kElevation].curves[1], 3);
    EXPECT_EQ(onPage(pageOf(drawn), far), onPage(drawing.page, far));
    EXPECT_EQ(inDocument(drawn, onPage(drawing.page, far)), far);
}

} // namespace
} // namespace kriva
