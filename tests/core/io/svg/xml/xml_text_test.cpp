#include "core/curve/text/utf8.h"
#include "core/io/svg/xml/xml_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

TEST(XmlText, escapesMarkup) {
    EXPECT_EQ(xmlText("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&apos;");
    EXPECT_EQ(xmlText("]]>"), "]]&gt;");
    EXPECT_EQ(xmlText("крива č 🙂"), "крива č 🙂");
}

TEST(XmlText, replacesWhatXmlDoesNotAllow) {
    const std::string replacement = "\xEF\xBF\xBD";
    EXPECT_EQ(xmlText("a\x01\n\x7f"), "a" + replacement + replacement + replacement);
    EXPECT_EQ(xmlText("\u0085"), replacement);
    EXPECT_EQ(xmlText("\uFFFE\uFFFF"), replacement + replacement);
    EXPECT_EQ(xmlText("\xff"), replacement);
    EXPECT_EQ(xmlText("\xed\xa0\x80"), replacement) << "a surrogate";
    EXPECT_EQ(xmlText("\xc0\xaf"), replacement + replacement) << "an overlong form";
    EXPECT_EQ(xmlText("\xe2\x82"), replacement + replacement) << "cut off";
}

TEST(XmlJson, writesWhatXmlDoesNotAllowAsJsonEscapes) {
    EXPECT_EQ(xmlJson("{\"a\": \"\u007f\u0085\uFFFE]]>&<\"}"), "{\"a\": \"\\u007f\\u0085\\ufffe]]&gt;&amp;&lt;\"}");
}

RC_GTEST_PROP(XmlText, holdsNoMarkupWhateverItIsGiven, (const std::string& bytes)) {
    const std::string text = xmlText(bytes);
    RC_ASSERT(text.find_first_of("<>\"'") == std::string::npos);
    forEachCharacter(text, [](std::optional<char32_t> c, std::string_view) { RC_ASSERT(c && *c >= 0x20); });
}

} // namespace
} // namespace kriva
