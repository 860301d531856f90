#include "core/curve/limits.h"
#include "core/io/json/document_json.h"
#include "core/io/open.h"
#include "core/io/svg/svg_reader.h"
#include "core/io/svg/svg_writer.h"
#include "tests/support/any_document.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

const TextSource kTexts{[](Caption) { return "Word"; }, [](double, int) { return std::string(); }, "en"};

constexpr std::string_view kJson = R"({"format":"kriva","version":1,"title":"t"})";

std::string around(std::string_view inside) {
    return std::string("<svg xmlns='http://www.w3.org/2000/svg'>").append(inside).append("</svg>");
}

std::string held(std::string_view json) {
    return around(std::string("<metadata><k:document xmlns:k='https://kriva.invalid/ns'>")
                      .append(json)
                      .append("</k:document></metadata>"));
}

std::optional<FileProblem> problemOf(std::string_view svg) {
    const auto read = readAnyDocument(svg);
    if (const FileError* error = std::get_if<FileError>(&read))
        return error->problem;
    return {};
}

std::string repeated(std::string_view text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

RC_GTEST_PROP(SvgReader, givesTheDocumentBackBitForBit, ()) {
    const Document document = *test::anyDocument();
    for (const SheetIndex sheet : {test::kElevation, test::kSubdivision}) {
        const auto read = readAnyDocument(writeSheetSvg(document, sheet, kTexts));
        RC_ASSERT(std::holds_alternative<Document>(read));
        // The text tells -0.0 from 0.0, which compare equal.
        RC_ASSERT(writeDocument(std::get<Document>(read)) == writeDocument(document));
    }
}

TEST(SvgReader, findsTheDocumentUnderAnyPrefix) {
    const std::string json(kJson);
    EXPECT_FALSE(problemOf(held(json)));
    EXPECT_FALSE(problemOf("<svg xmlns:ns0='https://kriva.invalid/ns'><metadata id='m'>\n <rdf:RDF/>\n "
                           "<ns0:document\n id='d'>\n" +
                           json + "\n</ns0:document></metadata></svg>"));
    EXPECT_FALSE(
        problemOf(around("<metadata><document xmlns='https://kriva.invalid/ns'>" + json + "</document></metadata>")));
    EXPECT_FALSE(problemOf(around("<metadata><k:document xmlns:k='https://kriva.invalid/ns'><![CDATA[" + json +
                                  "]]></k:document></metadata>")));
}

TEST(SvgReader, saysWhereNoDocumentIsInside) {
    const std::string json(kJson);
    EXPECT_EQ(problemOf(around("")), FileProblem::noDocumentInside);
    EXPECT_EQ(problemOf(around("<metadata><document>" + json + "</document></metadata>")),
              FileProblem::noDocumentInside);
    EXPECT_EQ(problemOf(around("<metadata><k:document xmlns:k='other'>" + json + "</k:document></metadata>")),
              FileProblem::noDocumentInside);
}

TEST(SvgReader, namesThePlaceOfAFaultInTheDocumentInside) {
    const auto read = readAnyDocument(held(R"({"format":"kriva","version":1,"sheets":{"elevation":{"curve":[]}}})"));
    EXPECT_EQ(std::get<FileError>(read).place, "sheets.elevation.curve");
    const auto cut = readAnyDocument("<svg>\n" + held(R"({"format":)") + "</svg>");
    EXPECT_EQ(std::get<FileError>(cut).problem, FileProblem::noDocumentInside) << "not a child of the root";
    const auto broken = readAnyDocument("<!-- -->\n" + held(R"({"format":)"));
    EXPECT_EQ(std::get<FileError>(broken).problem, FileProblem::notJson);
    EXPECT_EQ(std::get<FileError>(broken).line, 2);
}

TEST(SvgReader, refusesWhatIsNoXml) {
    EXPECT_EQ(problemOf("<svg"), FileProblem::notXml);
    EXPECT_EQ(problemOf("<svg><g></svg>"), FileProblem::notXml);
    EXPECT_EQ(problemOf("<!-- only a comment -->"), FileProblem::notXml);
    const auto read = readAnyDocument("<svg>\n<g a=1/></svg>");
    EXPECT_EQ(std::get<FileError>(read).line, 2);
}

TEST(SvgReader, refusesADocumentTypeWithAnInternalSubset) {
    EXPECT_EQ(problemOf("<!DOCTYPE svg [<!ENTITY a 'aaaa'>]><svg>&a;</svg>"), FileProblem::internalSubset);
    EXPECT_FALSE(problemOf("<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/[]'>" + held(kJson)));
}

TEST(SvgReader, takesElementsUpToTheLimits) {
    const std::string document = held(kJson).substr(around("").find("</svg>"));
    const auto inSvg = [&](const std::string& inside) { return "<svg>" + inside + document; };
    const int nested = limits::kXmlNesting - 1;
    EXPECT_FALSE(problemOf(inSvg(repeated("<g>", nested) + repeated("</g>", nested))));
    EXPECT_EQ(problemOf(inSvg(repeated("<g>", nested + 1) + repeated("</g>", nested + 1))), FileProblem::nestedTooDeep);
    const auto attributes = [](int count) {
        std::string tag = "<g";
        for (int i = 0; i < count; ++i)
            tag.append(" a").append(std::to_string(i)).append("='='");
        return tag + "/>";
    };
    EXPECT_FALSE(problemOf(inSvg(attributes(limits::kXmlAttributes))));
    EXPECT_EQ(problemOf(inSvg(attributes(limits::kXmlAttributes + 1))), FileProblem::tooManyAttributes);
    const int others = 3; // svg, metadata and the document
    EXPECT_FALSE(problemOf(inSvg(repeated("<g/>", limits::kXmlElements - others))));
    EXPECT_EQ(problemOf(inSvg(repeated("<g/>", limits::kXmlElements - others + 1))), FileProblem::tooManyElements);
}

TEST(SvgReader, countsNothingInsideCommentsAndTexts) {
    const std::string manyTags = repeated("<g>", limits::kXmlNesting + 1);
    EXPECT_FALSE(problemOf("<!--" + manyTags + "-->" + held(kJson)));
    EXPECT_FALSE(problemOf(held(std::string("<![CDATA[").append(kJson).append("]]><!--" + manyTags + "-->"))));
}

TEST(SvgReader, refusesFilesPastTheLimit) {
    std::string svg = held(kJson);
    svg.resize(limits::kFileBytes, ' ');
    EXPECT_FALSE(problemOf(svg));
    svg += ' ';
    EXPECT_EQ(problemOf(svg), FileProblem::tooLarge);
}

TEST(ReadAnyDocument, decidesByTheContent) {
    EXPECT_FALSE(problemOf(kJson));
    EXPECT_FALSE(problemOf("\xEF\xBB\xBF\n " + held(kJson)));
    EXPECT_EQ(problemOf(std::string("\xEF\xBB\xBF").append(kJson)), FileProblem::notJson);
    EXPECT_EQ(problemOf(""), FileProblem::notJson);
}

} // namespace
} // namespace kriva
