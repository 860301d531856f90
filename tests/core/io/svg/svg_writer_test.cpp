#include "core/figure/labels.h"
#include "core/io/json/document_json.h"
#include "core/io/svg/svg_writer.h"
#include "tests/support/any_document.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>
#include <pugixml.hpp>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::HasSubstr;
using testing::Not;

const TextSource kWriterTexts{
    [](Caption caption) { return caption == ElevationCurve::kCaption ? "Elevation" : "Word"; },
    [](double, int) { return std::string(); }, "en"};

Document documentOf(std::vector<Points> polygons) {
    Document document;
    for (Points& points : polygons)
        document.sheets[test::kElevation].curves.emplace_back(ElevationCurve{"", std::move(points), 0, {}, {}});
    return document;
}

std::string svgOf(const Document& document, const DrawingOptions& drawing = {}) {
    return writeSheetSvg(document, test::kElevation, kWriterTexts, drawing);
}
std::string svgWithoutDocument(const Document& document, const SvgOptions& options = {}) {
    return writeSvg(drawingOf(document, test::kElevation, kWriterTexts), kWriterTexts, options);
}

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document xml;
    EXPECT_TRUE(xml.load_buffer(svg.data(), svg.size())) << svg;
    return xml;
}

const Points kArch{{0, 0}, {1, 2}, {3, 2}, {4, 0}};

TEST(SvgWriter, statesItsSizeInMillimetresAndTheViewBoxInTheSameNumbers) {
    const std::string svg = svgOf(documentOf({kArch}));
    EXPECT_THAT(svg, HasSubstr(R"(width="120mm" height="66mm" viewBox="0 0 120 66" role="img" xml:lang="en")"));
}

TEST(SvgWriter, writesOneGroupForEachLayerAndOnePathForEachShownCurve) {
    Document document = documentOf({kArch, {{0, 0}, {1, 1}}, {{2, 0}, {5, 1}, {3, 2}}});
    document.sheets[test::kElevation].curves[1] = withView(document.sheets[test::kElevation].curves[1], {false});
    const pugi::xml_document xml = parsed(svgOf(document));
    const pugi::xml_node curves = xml.document_element().find_child_by_attribute("g", "id", "layer-curve");
    std::vector<std::string> ids;
    for (const pugi::xml_node path : curves.children("path"))
        ids.emplace_back(path.attribute("id").value());
    EXPECT_EQ(ids, (std::vector<std::string>{"curve-0", "curve-2"}));
    EXPECT_STREQ(curves.find_child_by_attribute("id", "curve-0").attribute("d").value(),
                 "M 6,49.2 C 27.6,6 70.8,6 92.4,49.2");
    EXPECT_TRUE(xml.document_element().find_child_by_attribute("g", "id", "layer-control-polygon"));
}

TEST(SvgWriter, givesNoIdTwice) {
    std::set<std::string> ids;
    Document document = documentOf({kArch, kArch});
    const pugi::xml_document xml = parsed(svgOf(document));
    for (const pugi::xpath_node found : xml.select_nodes("//*[@id]"))
        EXPECT_TRUE(ids.insert(found.node().attribute("id").value()).second) << found.node().attribute("id").value();
}

TEST(SvgWriter, usesPresentationAttributesOnly) {
    const std::string svg = svgWithoutDocument(documentOf({kArch}));
    for (const char* word : {" style=", "class", "clip", "marker", "transform", "<defs", "<use"})
        EXPECT_THAT(svg, Not(HasSubstr(word)));
}

TEST(SvgWriter, setsSubscriptsAsLoweredParts) {
    const pugi::xml_document xml = parsed(svgOf(documentOf({kArch})));
    const pugi::xml_node text = xml.select_node("//text").node();
    EXPECT_STREQ(text.text().get(), "b");
    EXPECT_STREQ(text.child("tspan").text().get(), "0");
    const std::string lowering = text.child("tspan").attribute("dy").value();
    EXPECT_FALSE(lowering.empty());
    EXPECT_NE(lowering.front(), '-');
}

TEST(SvgWriter, leavesTheDocumentOutWhereAsked) {
    EXPECT_THAT(svgOf(documentOf({kArch})), HasSubstr("<metadata>"));
    EXPECT_THAT(svgWithoutDocument(documentOf({kArch})), Not(HasSubstr("<metadata>")));
}

TEST(SvgWriter, roundsCoordinatesAndNeverTheSizeOfThePage) {
    const std::string svg = svgWithoutDocument(documentOf({{{0, 0}, {1, 2}, {3, 1}}}), {.decimals = 1});
    EXPECT_THAT(svg, HasSubstr(R"(width="120mm" height="84mm")"));
    EXPECT_THAT(svg, HasSubstr(R"(d="M 6,78 Q 42,6 114,42")"));
}

TEST(SvgWriter, makesLayersForInkscapeOnlyWhereAsked) {
    const std::string svg = svgWithoutDocument(documentOf({kArch}), {.hasInkscapeLayers = true});
    const pugi::xml_document xml = parsed(svg);
    const pugi::xml_node layer = xml.document_element().find_child_by_attribute("g", "id", "layer-curve");
    EXPECT_STREQ(layer.attribute("inkscape:groupmode").value(), "layer");
    EXPECT_STREQ(layer.attribute("inkscape:label").value(), "Word");
    EXPECT_THAT(svgWithoutDocument(documentOf({kArch})), Not(HasSubstr("inkscape")));
}

TEST(SvgWriter, keepsHostileTitlesHarmless) {
    Document document = documentOf({kArch});
    document.title = "<&>\"' \U0001F642 ]]> \x01";
    const pugi::xml_document xml = parsed(svgOf(document));
    EXPECT_STREQ(xml.document_element().child("title").text().get(), "<&>\"' \U0001F642 ]]> \uFFFD");
    document.title.clear();
    EXPECT_STREQ(parsed(svgOf(document)).document_element().child("title").text().get(), "Elevation");
}

TEST(SvgWriter, drawsNothingAndOnePointToo) {
    EXPECT_TRUE(parsed(svgOf(Document())).document_element());
    const std::string onePoint = svgOf(documentOf({{{1e9, -1e9}}}));
    EXPECT_THAT(onePoint, HasSubstr(R"(viewBox="0 0 12 12")"));
    EXPECT_THAT(onePoint, HasSubstr(R"(<circle cx="6" cy="6")"));
    EXPECT_THAT(svgOf(documentOf({{{1, 1}, {1, 1}}})), HasSubstr(R"(d="M 6,6 L 6,6")"));
}

/// Runs a program of the system on a file; nothing where the program is not installed.
std::optional<bool> accepts(const std::string& program, const std::string& svg) {
    if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0)
        return {};
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "kriva_svg_writer_test.svg";
    std::ofstream(file) << svg;
    const std::string options = program == "xmllint" ? " --noout " : " ";
    return std::system((program + options + file.string() + " >/dev/null 2>&1").c_str()) == 0;
}

TEST(SvgWriter, isReadByOtherPrograms) {
    Document document = documentOf({kArch, {{0, 0}, {5, 5}, {-3, 2}, {8, 8}, {9, 1}, {2, 2}}});
    document.title = "<&>\"' \U0001F642 ]]> \x01 \u0085";
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const char* program : {"xmllint", "rsvg-convert"})
            EXPECT_TRUE(accepts(program, svgOf(document, {.theme = theme})).value_or(true)) << program;
}

/// Every document of the tests' data, with curves of all sheets.
std::vector<Document> cases() {
    std::vector<Document> documents;
    for (const auto& file : std::filesystem::directory_iterator(KRIVA_TEST_DATA "/cases")) {
        if (file.path().extension() != ".kriva")
            continue;
        std::ifstream stream(file.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        documents.push_back(std::get<Document>(readDocument(text)));
    }
    return documents;
}

TEST(SvgWriter, namesThePathOfEveryCurveOfEverySheet) {
    std::size_t curves = 0;
    for (const Document& document : cases()) {
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
            const pugi::xml_document xml = parsed(writeSheetSvg(document, sheet, kWriterTexts));
            const pugi::xml_node layer = xml.document_element().find_child_by_attribute("g", "id", "layer-curve");
            for (std::size_t i = 0; i < document.sheets[sheet].curves.size(); ++i, ++curves)
                EXPECT_TRUE(
                    layer.find_child_by_attribute("path", "id", ("curve-" + decimal(static_cast<int>(i))).c_str()))
                    << sheetName(sheet) << i;
        }
    }
    EXPECT_GT(curves, 0U);
}

RC_GTEST_PROP(SvgWriter, isWellFormedAndWithoutExponentsAndTheSameTwice, ()) {
    const Document document = *test::anyDocument();
    for (const SheetIndex sheet : {test::kElevation, test::kSubdivision}) {
        const std::string svg = writeSheetSvg(document, sheet, kWriterTexts);
        RC_ASSERT(svg == writeSheetSvg(document, sheet, kWriterTexts));
        pugi::xml_document xml;
        RC_ASSERT(xml.load_buffer(svg.data(), svg.size()));
        for (const pugi::xpath_node path : xml.select_nodes("//path")) {
            const std::string_view data = path.node().attribute("d").value();
            RC_ASSERT(data.find_first_not_of("MLQCZ -.,0123456789") == std::string_view::npos);
        }
    }
}

} // namespace
} // namespace kriva
