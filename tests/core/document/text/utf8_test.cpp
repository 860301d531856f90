#include "core/document/text/utf8.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace kriva
