#include "core/curve/text/utf8.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace kriva {
namespace {

TEST(Utf8, readsCharactersOfAllLengths) {
    std::vector<char32_t> codePoints;
    forEachCharacter("a\u00e9\u20ac\U0001F642",
                     [&](std::optional<char32_t> c, std::string_view) { codePoints.push_back(c.value()); });
    EXPECT_EQ(codePoints, (std::vector<char32_t>{'a', 0xe9, 0x20ac, 0x1f642}));
}

TEST(Utf8, takesOffBlanksOfAnyKindAtBothEnds) {
    EXPECT_EQ(withoutOuterBlanks(" \t\r\n\u00a0\u2003a b\u00e9\u3000\u0085 \v"), "a b\u00e9");
    EXPECT_EQ(withoutOuterBlanks("\u2028 \u202f"), "");
    EXPECT_EQ(withoutOuterBlanks(""), "");
    EXPECT_EQ(withoutOuterBlanks("\x80 \xa0"), "\x80 \xa0") << "no UTF-8 is no blank";
    EXPECT_EQ(withoutOuterBlanks("\u200b"), "\u200b") << "has no width, but is none";
}

TEST(Utf8, takesASurrogateForOneCharacterThatIsNone) {
    EXPECT_EQ(asUtf8("\xED\xA0\x80\xED\xBF\xBF"), "\uFFFD\uFFFD");
    EXPECT_EQ(firstCharacter("\xED\xA0\x80").bytes.size(), 3u);
}

TEST(Utf8, textsAreMadeWellFormedAndLeftAloneWhereTheyAre) {
    for (const std::string_view text : {"", "abc", "крива", "\U0001F642\u202e\x01"}) {
        EXPECT_TRUE(isUtf8(text));
        EXPECT_EQ(asUtf8(text), text);
    }
    EXPECT_FALSE(isUtf8("a\xE4"));
    EXPECT_EQ(asUtf8("a\xE4\xC0\xAF z"), "a\uFFFD\uFFFD\uFFFD z");
    EXPECT_EQ(asUtf8(std::string_view("a\0b", 3)), "a\uFFFDb");
}

RC_GTEST_PROP(Utf8, anyBytesMakeATextThatStaysAsItIs, (const std::string& bytes)) {
    const std::string text = asUtf8(bytes);
    RC_ASSERT(isUtf8(text));
    RC_ASSERT(asUtf8(text) == text);
}

TEST(IsUnprintable, isTrueForControlsSeparatorsAndBidirectionalMarks) {
    for (const char32_t c :
         {0x00, 0x1f, 0x7f, 0x80, 0x9f, 0x061c, 0x200e, 0x200f, 0x2028, 0x2029, 0x202a, 0x202e, 0x2066, 0x2069})
        EXPECT_TRUE(isUnprintable(c)) << static_cast<unsigned>(c);
    for (const char32_t c : {0x20, 0x7e, 0xa0, 0x061b, 0x200b, 0x200d, 0x2027, 0x202f, 0x2065, 0x206a, 0x1f642})
        EXPECT_FALSE(isUnprintable(c)) << static_cast<unsigned>(c);
}

} // namespace
} // namespace kriva
