#include "core/document/conversion.h"
#include "core/document/limit_check.h"
#include "core/document/report.h"
#include "core/document/sheet_figure.h"
#include "core/io/json/document_json.h"
#include "core/io/json/fragment.h"
#include "core/io/latex/tikz_writer.h"
#include "core/io/svg/drawn_document.h"
#include "core/io/svg/svg_reader.h"
#include "core/io/svg/svg_writer.h"
#include "core/io/tables/points_writer.h"
#include "tests/support/sheet_curves.h"
#include "tests/support/sheet_svg.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::HasSubstr;

const SheetIndex kOffset = sheetNamed("offset").value();
const TextSource kTexts{[](Caption caption) { return std::string(caption.words()); },
                        [](double, int) { return std::string("0"); }, "en"};

OffsetCurve corner() {
    OffsetCurve curve;
    curve.name = "Corner";
    curve.points = {{0, 0}, {4, 0}, {4, 3}};
    curve.times = 2;
    return curve;
}

Document withCorner() {
    Document document;
    document.active = kOffset;
    document.sheets[kOffset].curves = test::curves({corner()});
    return document;
}

TEST(Offset, isOneSheetMoreBehindTheOthers) {
    EXPECT_EQ(kOffset, kSheetCount - 1);
    EXPECT_EQ(sheetName(kOffset), "offset");
    EXPECT_EQ(captionOf(kOffset), OffsetCurve::kCaption);
    EXPECT_EQ(layersOf(kOffset).front().name, "offsets");
}

TEST(Offset, movesCornersAlongTheirBisectors) {
    EXPECT_EQ(offsetPolygon(corner().points, 1), (Points{{0, 1}, {3, 1}, {3, 3}}));
}

TEST(Offset, isSavedAndOpenedBitForBit) {
    const Document document = withCorner();
    const std::string text = writeDocument(document);
    EXPECT_THAT(text, HasSubstr("\"offset\""));
    EXPECT_EQ(std::get<Document>(readDocument(text)), document);
    const Fragment fragment{Fragment::Content::curve, Curve(corner())};
    EXPECT_EQ(std::get<Fragment>(readFragment(writeFragment(fragment))), fragment);
}

TEST(Offset, isRefusedWithThePlaceOfTheFault) {
    const auto read = readDocument(
        R"({"format":"kriva","version":1,"sheets":{"offset":{"curves":[{"points":[[0,0]],"times":101}]}}})");
    EXPECT_EQ(std::get<FileError>(read).place, "sheets.offset.curves[0].times");
    OffsetCurve tooLong;
    tooLong.points.resize(100'001);
    EXPECT_EQ(limitErrorWith({}, {}, Curve(tooLong)).value().problem, FileProblem::tooManyPointsInCurve);
}

TEST(Offset, isReported) {
    const std::string report = std::get<std::string>(reportJson(withCorner(), "corner.kriva", kOffset));
    EXPECT_THAT(report, HasSubstr("\"offset\""));
    EXPECT_THAT(report, HasSubstr("\"length\": 7"));
    EXPECT_EQ(results(Curve(corner())).front(), (Result{Caption::length, "", 7.0}));
}

TEST(Offset, isDrawnUnderItsView) {
    Sheet sheet = withCorner().sheets[kOffset];
    const auto offsets = [&] {
        const Figure figure = figureOf(sheet, kOffset);
        const auto layer = std::ranges::find(figure.layers, "offsets", &Layer::name);
        return layer == figure.layers.end() ? 0 : layer->strokes.size();
    };
    EXPECT_EQ(offsets(), 2u);
    sheet = atFrame(sheet, {FramePlace::Over::stage, 5}).value().value;
    EXPECT_EQ(offsets(), 5u);
    sheet.view.layers["offsets"] = false;
    EXPECT_EQ(offsets(), 0u);
}

TEST(Offset, isExportedInEveryFormatAndReadBack) {
    const Document document = withCorner();
    const std::string svg = test::sheetSvg(document, kOffset, kTexts);
    EXPECT_THAT(svg, HasSubstr("<g id=\"layer-offsets\""));
    EXPECT_EQ(std::get<Document>(readDocumentFromSvg(svg)), document);
    EXPECT_FALSE(drawnDocument(svg, document)) << "the lines are still those of the document";
    const Drawing drawing = drawingOf(document, kOffset, kTexts);
    EXPECT_THAT(drawing.description, HasSubstr("Offset polygons: "));
    EXPECT_THAT(writeTikz(drawing, kTexts, TikzKind::fragment), HasSubstr("\\draw"));
    EXPECT_THAT(writePointsCsv(document.sheets[kOffset]), HasSubstr("4"));
}

TEST(Offset, takesThePointsOfOtherSheets) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        const Curve other = converted(Curve(corner()), sheet);
        EXPECT_EQ(other.index(), sheet);
        EXPECT_EQ(pointsOf(converted(other, kOffset)), corner().points);
    }
}

} // namespace
} // namespace kriva
