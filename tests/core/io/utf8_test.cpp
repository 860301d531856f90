#include "core/io/utf8.h"

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

} // namespace
} // namespace kriva
