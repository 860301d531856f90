#include "core/io/utf8.h"
#include "core/io/xml_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>

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
    EXPECT_EQ(xmlText("\xed\xa0\x80"), replacement + replacement + replacement) << "a surrogate";
    EXPECT_EQ(xmlText("\xc0\xaf"), replacement + replacement) << "an overlong form";
    EXPECT_EQ(xmlText("\xe2\x82"), replacement + replacement) << "cut off";
}

TEST(XmlJson, writesWhatXmlDoesNotAllowAsJsonEscapes) {
    EXPECT_EQ(xmlJson("{\"a\": \"\u007f\u0085\uFFFE]]>&<\"}"), "{\"a\": \"\\u007f\\u0085\\ufffe]]&gt;&amp;&lt;\"}");
}

TEST(Utf8, readsCharactersOfAllLengths) {
    std::vector<char32_t> codePoints;
    forEachCharacter("a\u00e9\u20ac\U0001F642",
                     [&](std::optional<char32_t> c, std::string_view) { codePoints.push_back(c.value()); });
    EXPECT_EQ(codePoints, (std::vector<char32_t>{'a', 0xe9, 0x20ac, 0x1f642}));
}

TEST(PlainNumber, hasNoExponentAndNoIdleZeros) {
    EXPECT_EQ(plainNumber(120, 11), "120");
    EXPECT_EQ(plainNumber(0.1, 11), "0.1");
    EXPECT_EQ(plainNumber(-0.0, 4), "0");
    EXPECT_EQ(plainNumber(-1e-9, 4), "0");
    EXPECT_EQ(plainNumber(1.00004999, 4), "1");
    EXPECT_EQ(plainNumber(1e20, 0), "100000000000000000000");
    EXPECT_EQ(plainNumber(100, 0), "100");
}

RC_GTEST_PROP(PlainNumber, isWithinHalfOfItsLastDecimal, (int whole, int billionths)) {
    const double value = whole + billionths * 1e-9;
    const std::string text = plainNumber(value, 6);
    double read = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read, std::chars_format::fixed);
    RC_ASSERT(error == std::errc());
    RC_ASSERT(end == text.data() + text.size());
    RC_ASSERT(std::abs(read - value) <= 5.0001e-7 + 1e-15 * std::abs(value));
}

RC_GTEST_PROP(XmlText, holdsNoMarkupWhateverItIsGiven, (const std::string& bytes)) {
    const std::string text = xmlText(bytes);
    RC_ASSERT(text.find_first_of("<>\"'") == std::string::npos);
    forEachCharacter(text, [](std::optional<char32_t> c, std::string_view) { RC_ASSERT(c && *c >= 0x20); });
}

} // namespace
} // namespace kriva
