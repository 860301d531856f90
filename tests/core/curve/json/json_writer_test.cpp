#include "core/curve/json/json_tape.h"
#include "core/curve/json/json_writer.h"
#include "core/curve/text/utf8.h"
#include "tests/support/long_run.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace kriva {
namespace {

/// Finite doubles with all exponents alike often, negative, denormal and whole ones among them.
std::vector<double> randomDoubles(std::size_t count) {
    std::mt19937_64 random(20240607);
    std::vector<double> numbers{0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1e9, 0.1, 1.0 / 3, 1e22, 1e23};
    while (numbers.size() < count) {
        const double number = std::bit_cast<double>(random());
        if (std::isfinite(number))
            numbers.push_back(numbers.size() % 8 == 0 ? std::trunc(number) : number);
    }
    return numbers;
}

std::vector<double> readBack(const std::vector<double>& numbers, JsonWriter::Digits digits) {
    JsonWriter json(digits, 0);
    json.value(numbers);
    const auto tape = parseJson(std::move(json).take());
    std::vector<double> read;
    if (const JsonTape* list = std::get_if<JsonTape>(&tape))
        for (std::size_t i = 1; i < list->entries.size(); ++i)
            read.push_back(list->entries[i].number);
    return read;
}

bool areSameBits(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

// A million where time does not count.
TEST(JsonWriter, writesDoublesThatReadBackBitForBit) {
    const std::vector<double> numbers = randomDoubles(test::isLongRun() ? 1'000'000 : 50'000);
    EXPECT_TRUE(areSameBits(readBack(numbers, JsonWriter::Digits::shortest), numbers));
    EXPECT_TRUE(areSameBits(readBack(numbers, JsonWriter::Digits::seventeen), numbers));
}

std::string written(const auto& value, JsonWriter::Digits digits = JsonWriter::Digits::shortest) {
    JsonWriter json(digits, 0);
    json.value(value);
    std::string text = std::move(json).take();
    text.pop_back(); // the end of the line
    return text;
}

TEST(JsonWriter, writesAsFewOrAsManyDigitsAsAsked) {
    EXPECT_EQ(written(0.1), "0.1");
    EXPECT_EQ(written(0.1, JsonWriter::Digits::seventeen), "0.10000000000000001");
    EXPECT_EQ(written(5.0), "5");
    EXPECT_EQ(written(-0.0), "-0.0");
    EXPECT_EQ(written(-0.0, JsonWriter::Digits::seventeen), "-0.0");
}

TEST(JsonWriter, writesNullForWhatIsNotFinite) {
    EXPECT_EQ(written(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "null");
    EXPECT_EQ(written(std::optional<double>()), "null");
    EXPECT_EQ(written(Point{1, -std::numeric_limits<double>::infinity()}), "[1, null]");
}

TEST(JsonWriter, escapesWhatATextMayNotHold) {
    EXPECT_EQ(written("a\"b\\c\n\x01\x7f/крива"), R"("a\"b\\c\u000a\u0001\u007f/крива")");
}

TEST(JsonWriter, escapesWhatTurnsALineAroundOrEndsIt) {
    EXPECT_EQ(written("a\u202eb\u2066\u0085\u009b\u200f\u061c\u2028"),
              R"("a\u202eb\u2066\u0085\u009b\u200f\u061c\u2028")");
    EXPECT_EQ(written("\u200b\u200d\u00a0\u2010"), "\"\u200b\u200d\u00a0\u2010\"");
}

TEST(JsonWriter, writesNothingThatNoReaderTakes) {
    const std::string hostile[] = {"\xE4",      "\xED\xA0\x80",      "\xC0\xAF", "\xF5\x80\x80\x80",
                                   "a\xF0\x9F", std::string(1, '\0')};
    for (const std::string& text : hostile) {
        JsonWriter json(JsonWriter::Digits::shortest, 0);
        json.beginObject().member("a" + text, text).endObject();
        const std::string bytes = std::move(json).take();
        EXPECT_TRUE(isUtf8(bytes));
        EXPECT_TRUE(std::holds_alternative<JsonTape>(parseJson(bytes))) << bytes;
        EXPECT_NE(bytes.find(kReplacementCharacter), std::string::npos) << bytes;
    }
}

TEST(JsonWriter, writesListsOfLists) {
    JsonWriter json(JsonWriter::Digits::shortest, 0);
    json.value(std::vector<Points>{{{0, 1}, {2, 3}}, {}});
    EXPECT_EQ(std::move(json).take(), "[[[0, 1], [2, 3]], []]\n");
}

TEST(JsonWriter, breaksLinesDownToTheDepthAsked) {
    JsonWriter json(JsonWriter::Digits::shortest, 1);
    json.beginObject().member("a", 1).key("b").beginObject().member("c", true).endObject();
    json.key("d").beginList().endList().endObject();
    EXPECT_EQ(std::move(json).take(), "{\n  \"a\": 1,\n  \"b\": {\"c\": true},\n  \"d\": []\n}\n");
}

} // namespace
} // namespace kriva
