#include "core/io/svg/xml/xml_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace kriva {
namespace {

std::optional<FileProblem> outlineProblem(std::string_view xml) {
    const std::optional<FileError> error = xmlError(xml);
    return error ? std::optional(error->problem) : std::nullopt;
}

TEST(XmlError, isNothingForWhatIsWellFormed) {
    const std::string_view wellFormed[] = {
        "<a/>",
        "<a></a>",
        " <a />\n",
        "\xEF\xBB\xBF<?xml version='1.0' encoding='UTF-8' standalone=\"no\"?>\n<a b='1' c = \"'2'\" ></a >",
        "<?xml version=\"1.0\"?><!-- - --><?pi?><!DOCTYPE svg PUBLIC '>' \"http://[]\"><a/><!-- --> <?p q?>",
        "<a:b xmlns:a='x' a:c='>'>&lt;&gt;&amp;&quot;&apos;&#65;&#x41;&#xfffd;<c><![CDATA[<&]]></c>]] ></a:b>",
        "<крива к='к'/>",
        "<a>\xE4</a>",     // some encoding that it does not name
        "<a>&#xD800;</a>", // no character, which is no matter of form here
        "<?xml version='1.0' encoding='windows-1251'?><a b='\xCA'/>",
        "<?xml version='1.0' encoding='klingon'?><a b='c'/>", // ASCII, as most are
        "<?xml version='1.0' encoding='utf8'?><a b='č'/>",
        "<a>&#9;&#10;&#13;&#x20;&#xd7ff;&#xe000;&#xFFFD;&#x10000;&#x10FFFF;\t\n\r\x7f</a>",
        "<a><![CDATA[&#0;]]><!-- &#0; --></a>", // there it is no reference
        "<?xml version='1.0' encoding='windows-1251'?><a b='\xEF\xBF\xBE'/>",
    };
    for (const std::string_view xml : wellFormed)
        EXPECT_EQ(outlineProblem(xml), std::nullopt) << xml;
}

TEST(XmlError, refusesWhatIsIllFormed) {
    const std::string_view illFormed[] = {
        "",
        "a",
        "<",
        "<a",
        "<a>",
        "</a>",
        "<a></b>",
        "<a><b></a></b>",
        "a<a/>",
        "< a/>",
        "<1/>",
        "<a/ >",
        "<a b/>",
        "<a b=/>",
        "<a b=c/>",
        "<a b='/>",
        "<a b='<'/>",
        "<a b='1'c='2'/>",
        "<a b='&'/>",
        "<a>&</a>",
        "<a>& b</a>",
        "<a>&amp</a>",
        "<a>&#;</a>",
        "<a>&#x;</a>",
        "<a>&#12a;</a>",
        "<a>]]></a>",
        "<a><!-- -- --></a>",
        "<a><!-- ></a>",
        "<a><![CDATA[ ]></a>",
        "<![CDATA[]]><a/>",
        "<a><?xml version='1.0'?></a>",
        " <?xml version='1.0'?><a/>",
        "<a><? ?></a>",
        "<a><?b</a>",
        "<a><!b></a>",
        "<!DOCTYPE a",
        "<!DOCTYPE a><!DOCTYPE a><a/>",
        "<a/><!DOCTYPE a>",
        "<a></a",
    };
    for (const std::string_view xml : illFormed)
        EXPECT_EQ(outlineProblem(xml), FileProblem::notXml) << xml;
}

TEST(XmlError, refusesCharactersThatXmlDoesNotHaveWhereverTheyStand) {
    using Texts = std::vector<std::pair<std::string, std::string>>;
    const Texts characters{{std::string(1, '\0'), "U+0000"},
                           {"\x01", "U+0001"},
                           {"\x1f", "U+001F"},
                           {"\xEF\xBF\xBE", "U+FFFE"},
                           {"\xEF\xBF\xBF", "U+FFFF"}};
    const Texts places{{"<a>", "</a>"},     {"<a b='", "'/>"},  {"<a><![CDATA[", "]]></a>"},
                       {"<!--", "--><a/>"}, {"<?b ", "?><a/>"}, {"<?xml version='1.0' encoding='UTF-8'?><a>", "</a>"}};
    for (const auto& [bytes, code] : characters)
        for (const auto& [before, behind] : places) {
            const FileError error = xmlError(before + bytes + behind).value_or(FileError{});
            EXPECT_EQ(error.problem, FileProblem::noXmlCharacter) << before;
            EXPECT_EQ(error.words, std::vector<std::string>{code});
            EXPECT_EQ(error.column, static_cast<int>(before.size()) + 1);
        }
}

TEST(XmlError, refusesAnEncodingThatItDoesNotReadWhereMoreThanAsciiIs) {
    for (const std::string name : {"utf-16", "klingon", "Shift_JIS", "us-ascii"}) {
        const FileError error =
            xmlError("<?xml version='1.0' encoding=\"" + name + "\"?>\n<a b='č'/>").value_or(FileError{});
        EXPECT_EQ(error.problem, FileProblem::unknownEncoding) << name;
        EXPECT_EQ(error.line, 2);
        EXPECT_EQ(error.column, 7);
        ASSERT_EQ(error.words.size(), 1u);
        EXPECT_TRUE(std::ranges::equal(error.words[0], name, [](char a, char b) { return (a | 0x20) == (b | 0x20); }))
            << error.words[0];
    }
}

TEST(XmlError, refusesMoreThanOneOutermostElement) {
    EXPECT_EQ(outlineProblem("<a/><a/>"), FileProblem::secondRoot);
    EXPECT_EQ(outlineProblem("<a></a>b"), FileProblem::secondRoot);
    EXPECT_EQ(outlineProblem("<a/>&amp;"), FileProblem::secondRoot);
    EXPECT_EQ(xmlError("<a/>\n <b/>")->line, 2);
    EXPECT_EQ(xmlError("<a/>\n <b/>")->column, 2);
}

TEST(XmlError, namesARepeatedAttributeAndAnUnknownEntity) {
    const FileError repeated = xmlError("<a>\n<b c='1' d='2' c='3'/></a>").value();
    EXPECT_EQ(repeated.problem, FileProblem::repeatedAttribute);
    EXPECT_EQ(repeated.words, std::vector<std::string>{"c"});
    EXPECT_EQ(repeated.line, 2);
    for (const std::string_view xml : {"<a>&nbsp;</a>", "<a b='&nbsp;'/>"}) {
        const FileError unknown = xmlError(xml).value();
        EXPECT_EQ(unknown.problem, FileProblem::unknownEntity);
        EXPECT_EQ(unknown.words, std::vector<std::string>{"nbsp"});
    }
}

TEST(XmlError, refusesBytesThatAreNotOfTheEncodingThatTheTextNames) {
    const FileError error = xmlError("<?xml version='1.0' encoding = \"utf-8\" ?>\n<a b='\xCA'/>").value();
    EXPECT_EQ(error.problem, FileProblem::notInEncoding);
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 7);
}

} // namespace
} // namespace kriva
