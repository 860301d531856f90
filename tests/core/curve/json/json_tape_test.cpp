#include "core/curve/json/json_tape.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

namespace kriva {
namespace {

/// Why a text is refused; fails where it is not.
FileError refusalOf(std::string_view text) {
    const auto tape = parseJson(text);
    if (const FileError* error = std::get_if<FileError>(&tape))
        return *error;
    ADD_FAILURE() << "not refused: " << text.substr(0, 1000);
    return {};
}

JsonTape tapeOf(std::string_view text) {
    auto tape = parseJson(text);
    if (JsonTape* read = std::get_if<JsonTape>(&tape))
        return std::move(*read);
    ADD_FAILURE() << "refused: " << text.substr(0, 1000);
    return {};
}

double numberOf(std::string_view token) {
    const JsonTape tape = tapeOf(token);
    EXPECT_EQ(tape.entries.size(), 1u);
    return tape.entries.empty() ? 0 : tape.entries[0].number;
}

bool isNegativeZero(double x) {
    return x == 0 && std::signbit(x);
}

/// Sets the locale of numbers, if the system has it, while it lives.
class NumberLocale {
  public:
    explicit NumberLocale(const char* name)
        : before_(std::setlocale(LC_NUMERIC, nullptr))
        , isThere_(std::setlocale(LC_NUMERIC, name) != nullptr) {}
    ~NumberLocale() { std::setlocale(LC_NUMERIC, before_.c_str()); }
    NumberLocale(const NumberLocale&) = delete;
    NumberLocale& operator=(const NumberLocale&) = delete;
    [[nodiscard]] bool isThere() const { return isThere_; }

  private:
    std::string before_;
    bool isThere_;
};

TEST(JsonTape, laysValuesInTheOrderOfTheText) {
    const JsonTape tape = tapeOf(R"( {"a": [1, [], {}], "b": "x"} )");
    ASSERT_EQ(tape.entries.size(), 8u);
    EXPECT_EQ(tape.entries[0].kind, JsonKind::object);
    EXPECT_EQ(tape.entries[0].next, 8u);
    EXPECT_EQ(textOf(tape, 1), "a");
    EXPECT_EQ(tape.entries[2].kind, JsonKind::list);
    EXPECT_EQ(tape.entries[2].next, 6u);
    EXPECT_EQ(tape.entries[3].number, 1);
    EXPECT_EQ(tape.entries[4].next, 5u);
    EXPECT_EQ(textOf(tape, 6), "b");
    EXPECT_EQ(textOf(tape, 7), "x");
}

TEST(JsonTape, refusesWhatIsNoJsonWithLineAndColumn) {
    for (const std::string_view text : {"",
                                        " ",
                                        "[",
                                        "[1",
                                        "[1,]",
                                        "{\"a\"}",
                                        "{\"a\":}",
                                        "{a:1}",
                                        "{'a':1}",
                                        "[1]]",
                                        "[1] 2",
                                        "nul",
                                        "True",
                                        "NaN",
                                        "Infinity",
                                        "-",
                                        "01",
                                        "+1",
                                        ".5",
                                        "1.",
                                        "1e",
                                        "0x10",
                                        "// a\n1",
                                        "/* a */1",
                                        "\"a",
                                        "\"\\x\"",
                                        "\"\n\"",
                                        "\"\\ud800\"",
                                        "\"\\udc00\\ud800\"",
                                        "\"\xff\"",
                                        "\"\xc0\x80\"",
                                        "\"\xed\xa0\x80\"",
                                        "\"\xf4\x90\x80\x80\""}) {
        const FileError error = refusalOf(text);
        EXPECT_EQ(error.problem, FileProblem::notJson) << text;
        EXPECT_GE(error.line, 1) << text;
        EXPECT_GE(error.column, 1) << text;
    }
    const FileError error = refusalOf("[1,\n 2,\n  x]");
    EXPECT_EQ(error.line, 3);
    EXPECT_EQ(error.column, 3);
}

TEST(JsonTape, refusesAByteOrderMark) {
    const FileError error = refusalOf("\xEF\xBB\xBF[]");
    EXPECT_EQ(error.problem, FileProblem::notJson);
    EXPECT_EQ(error.line, 1);
    EXPECT_EQ(error.column, 1);
}

TEST(JsonTape, refusesANulByteWhereverItStands) {
    for (const std::string_view text : {std::string_view("[]\0", 3), std::string_view("[]\0junk", 7),
                                        std::string_view("\0[]", 3), std::string_view("[\"a\0\"]", 6)})
        EXPECT_EQ(refusalOf(text).problem, FileProblem::notJson);
    EXPECT_EQ(refusalOf(std::string_view("[\n]\0", 4)).line, 2);
}

TEST(JsonTape, goes64LevelsDeepAndNoFurther) {
    EXPECT_EQ(tapeOf(std::string(64, '[') + std::string(64, ']')).entries.size(), 64u);
    const FileError error = refusalOf("\n" + std::string(65, '[') + std::string(65, ']'));
    EXPECT_EQ(error.problem, FileProblem::nestedTooDeep);
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 65);
    std::string objects;
    for (int i = 0; i < 65; ++i)
        objects += "{\"a\":";
    EXPECT_EQ(refusalOf(objects).problem, FileProblem::nestedTooDeep);
}

TEST(JsonTape, readsNumbersOf1000CharactersAndNoLongerOnes) {
    const std::string longest = "0." + std::string(995, '0') + "1e0";
    EXPECT_EQ(numberOf(longest), 0);
    const FileError error = refusalOf("[1,\n  " + longest + "0]");
    EXPECT_EQ(error.problem, FileProblem::numberTooLong);
    EXPECT_EQ(error.numbers, std::vector<double>{1000});
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.column, 3);
    // Words and texts are not numbers, and many numbers are not a long one.
    EXPECT_EQ(refusalOf(std::string(2000, 'a')).problem, FileProblem::notJson);
    EXPECT_EQ(tapeOf('"' + std::string(2000, '1') + '"').entries.size(), 1u);
    std::string many = "[1";
    for (int i = 0; i < 1000; ++i)
        many += ",12";
    EXPECT_EQ(tapeOf(many + "]").entries.size(), 1002u);
}

TEST(JsonTape, hasBlanksOfEveryKindBetweenItsPartsAndBlanksAloneInTexts) {
    EXPECT_EQ(tapeOf("\r\n[\t1,\n\t\"a\\\\\"\n,\r\"\\\"\"\t]\n").entries.size(), 4u);
    for (const char* text : {"[\"\n\"]", "[\"\t\"]", "[\"\\\"\n\"]", "[\"\\\\\",\"\r\"]"})
        EXPECT_EQ(refusalOf(text).problem, FileProblem::notJson) << text;
    const FileError error = refusalOf("[1" + std::string(1000, '\n') + "2]");
    EXPECT_EQ(error.problem, FileProblem::notJson);
    EXPECT_EQ(error.line, 1001);
}

TEST(JsonTape, countsNoBracketsInsideTexts) {
    EXPECT_EQ(tapeOf('"' + std::string(100, '[') + "\\\"" + std::string(100, '{') + '"').entries.size(), 1u);
    std::string wide = "[";
    for (int i = 0; i < 100; ++i)
        wide += "[],";
    EXPECT_EQ(tapeOf(wide + "[]]").entries.size(), 102u);
}

TEST(JsonTape, readsNumbersToTheNearestDouble) {
    EXPECT_EQ(numberOf("0.1"), 0.1);
    EXPECT_EQ(numberOf("5e-324"), 5e-324);
    EXPECT_EQ(numberOf("2.4703282292062327e-324"), 0);      // just below half of the least double
    EXPECT_EQ(numberOf("2.4703282292062328e-324"), 5e-324); // just above
    EXPECT_EQ(numberOf("1.7976931348623157e308"), 1.7976931348623157e308);
    EXPECT_EQ(numberOf("9007199254740993"), 9007199254740992); // halfway between two: to even
    EXPECT_EQ(numberOf("-9223372036854775809"), -9223372036854775808.0);
    EXPECT_EQ(numberOf("18446744073709551616"), 18446744073709551616.0);
    EXPECT_EQ(numberOf("0." + std::string(400, '0') + "1e401"), 1);
    EXPECT_EQ(numberOf("1" + std::string(400, '0') + "e-400"), 1);
    EXPECT_EQ(numberOf("1e-400"), 0);
    EXPECT_TRUE(isNegativeZero(numberOf("-1e-400")));
}

TEST(JsonTape, keepsTheSignOfMinusZero) {
    for (const std::string_view token : {"-0", "-0.0", "-0e5", "-0.000"})
        EXPECT_TRUE(isNegativeZero(numberOf(token))) << token;
    EXPECT_FALSE(std::signbit(numberOf("0")));
    EXPECT_EQ(numberOf("-1"), -1);
}

TEST(JsonTape, takesNumbersBeyondTheRangeOfDoublesForInfiniteOnesAndTinyOnesForZero) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::string zeros(400, '0');
    const std::vector<std::string> large{"1e999",
                                         "1" + zeros,
                                         "1" + zeros + "e-50",
                                         "0." + zeros + "1e800",
                                         "1e" + zeros + "999",
                                         "1e+99999999999999999999",
                                         "0.1E99999999999"};
    for (const std::string& token : large) {
        EXPECT_EQ(numberOf(token), kInfinity) << token;
        EXPECT_EQ(numberOf("-" + token), -kInfinity) << token;
    }
    const std::vector<std::string> tiny{"1e-999",
                                        "0." + zeros + "1",
                                        "0." + zeros + "1e50",
                                        "1" + zeros + "e-800",
                                        "1e-99999999999999999999",
                                        "0e" + zeros + "9",
                                        "0.0e999",
                                        "0e99999999999999999999"};
    for (const std::string& token : tiny) {
        EXPECT_EQ(numberOf(token), 0) << token;
        EXPECT_TRUE(isNegativeZero(numberOf("-" + token))) << token;
    }
}

TEST(JsonTape, readsTheSameWhateverTheDecimalSignOfTheLocale) {
    int tried = 0;
    // A comma, and a sign of two bytes.
    for (const char* name :
         {"bg_BG.UTF-8", "sl_SI.UTF-8", "uk_UA.UTF-8", "de_DE.UTF-8", "ps_AF.UTF-8", "fa_IR.UTF-8"}) {
        const NumberLocale locale(name);
        if (!locale.isThere())
            continue;
        ++tried;
        EXPECT_EQ(numberOf("1234.5678"), 1234.5678) << name;
        EXPECT_EQ(numberOf("1.5e-320"), 1.5e-320) << name;
        EXPECT_EQ(numberOf("1.5e-400"), 0) << name;
        EXPECT_TRUE(std::isinf(numberOf("1.5e999"))) << name;
        EXPECT_EQ(refusalOf("[1,5 2]").problem, FileProblem::notJson) << name;
        const std::string sign = std::localeconv()->decimal_point;
        EXPECT_EQ(refusalOf("1" + sign + "5").problem, FileProblem::notJson) << name;
        EXPECT_NE(sign, ".") << name << ": reading must not change the locale";
    }
    if (tried == 0)
        GTEST_SKIP() << "no locale with another decimal sign is installed";
}

/// The JSON of a tape from an entry on; goes behind it.
nlohmann::json jsonOf(const JsonTape& tape, std::uint32_t& index) {
    const JsonEntry& entry = tape.entries[index++];
    switch (entry.kind) {
    case JsonKind::null:
        return nullptr;
    case JsonKind::boolean:
        return entry.number != 0;
    case JsonKind::number:
        return entry.number;
    case JsonKind::text:
        return std::string(textOf(tape, index - 1));
    case JsonKind::list:
    case JsonKind::object:
        break;
    }
    nlohmann::json json = entry.kind == JsonKind::list ? nlohmann::json::array() : nlohmann::json::object();
    while (index < entry.next) {
        if (entry.kind == JsonKind::list) {
            json.push_back(jsonOf(tape, index));
        } else {
            const std::string key(textOf(tape, index++));
            json[key] = jsonOf(tape, index); // of repeated keys the last, as the library has it
        }
    }
    return json;
}

RC_GTEST_PROP(JsonTape, takesWhatAnotherReaderTakesForTheSame, ()) {
    const auto parts = *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
        "[",       "]",    "{", "}",    ",",    ":",    "\"a\"", "\"b\":", "\"", "\\", "\\u00e9", "\\ud83d\\ude00",
        "\\ud83d", "/",    "n", "null", "true", "fals", "0",     "1",      "-",  "-0", ".5",      "e3",
        "E-2",     "1e-7", " ", "\n",   "\t",   "é",    "\xc3",  "\x7f"}));
    std::string text;
    for (const std::string& part : parts)
        text += part;
    // Most are no JSON by themselves: inside a list, a text or an object more of them are.
    const auto [before, behind] = *rc::gen::elementOf(
        std::vector<std::pair<std::string, std::string>>{{"", ""}, {"[", "]"}, {"\"", "\""}, {"{\"c\":", "}"}});
    text = before + text + behind;
    const NumberLocale point("C"); // for the other reader
    const auto read = parseJson(text);
    const nlohmann::json expected = nlohmann::json::parse(text, nullptr, false);
    RC_ASSERT(std::holds_alternative<JsonTape>(read) == !expected.is_discarded());
    if (expected.is_discarded())
        return;
    std::uint32_t end = 0;
    RC_ASSERT(jsonOf(std::get<JsonTape>(read), end) == expected);
    RC_ASSERT(end == std::get<JsonTape>(read).entries.size());
}

} // namespace
} // namespace kriva
