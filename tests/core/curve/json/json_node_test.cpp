#include "core/curve/json/json_node.h"

#include <gtest/gtest.h>

#include <functional>

namespace kriva {
namespace {

using Read = std::function<void(const JsonNode&)>;

/// Why reading a text is refused, nothing where it is not.
std::optional<FileError> refusal(std::string_view text, const Read& read) {
    const auto tape = parseJson(text);
    if (const FileError* error = std::get_if<FileError>(&tape))
        return *error;
    try {
        read(JsonNode(std::get<JsonTape>(tape)));
    } catch (const Refused& refused) {
        return refused.error;
    }
    return {};
}

FileProblem problemOf(std::string_view text, const Read& read) {
    const std::optional<FileError> error = refusal(text, read);
    EXPECT_TRUE(error) << "not refused: " << text;
    return error.value_or(FileError{}).problem;
}

void expectRefusals(std::initializer_list<std::string_view> texts, FileProblem problem, const Read& read) {
    for (const std::string_view text : texts)
        EXPECT_EQ(problemOf(text, read), problem) << text;
}

TEST(JsonNode, refusesValuesOfTheWrongType) {
    expectRefusals({"true", "null", "\"1\"", "[1]", "{}"}, FileProblem::expectedNumber,
                   [](const JsonNode& node) { (void)node.number(); });
    expectRefusals({"true", "null", "\"1\"", "[1]", "{}", "2.5", "-1", "10", "1e30", "1e-30"},
                   FileProblem::expectedWholeNumber, [](const JsonNode& node) { (void)node.wholeNumber(0, 9); });
    expectRefusals({"0", "1", "null", "\"true\"", "[]", "{}"}, FileProblem::expectedTrueOrFalse,
                   [](const JsonNode& node) { (void)node.trueOrFalse(); });
    expectRefusals({"0", "null", "false", "[]", "{}"}, FileProblem::expectedText,
                   [](const JsonNode& node) { (void)node.text(); });
    expectRefusals({"0", "null", "false", "\"\"", "{}"}, FileProblem::expectedList,
                   [](const JsonNode& node) { (void)node.listSize(5); });
    expectRefusals({"0", "null", "false", "\"\"", "[]"}, FileProblem::expectedObject,
                   [](const JsonNode& node) { const JsonObject object(node, {"a"}); });
    expectRefusals({"0", "null", "\"\"", "{}", "[]", "[1]", "[1,2,3]", "[1,null]", "[true,1]", "[1,\"2\"]", "[[1],2]",
                    "{\"x\":1,\"y\":2}"},
                   FileProblem::expectedTwoNumbers, [](const JsonNode& node) { (void)node.point(); });
    expectRefusals({"0", "null", "\"c\"", "\"\"", "\"A\"", "[\"a\"]"}, FileProblem::expectedOneOf,
                   [](const JsonNode& node) {
                       (void)node.oneOf<int>({{"a", 1}, {"b", 2}});
                   });
}

TEST(JsonNode, takesWholeNumbersHoweverTheyAreWritten) {
    for (const std::string_view text : {"5", "5.0", "5e0", "0.5e1", "50e-1"})
        EXPECT_FALSE(refusal(text, [](const JsonNode& node) { EXPECT_EQ(node.wholeNumber(5, 5), 5); })) << text;
}

TEST(JsonNode, refusesNumbersPastTheLimit) {
    const Read number = [](const JsonNode& node) { (void)node.number(); };
    const Read point = [](const JsonNode& node) { (void)node.point(); };
    EXPECT_FALSE(refusal("1e9", number));
    EXPECT_FALSE(refusal("[-1e9,1e9]", point));
    expectRefusals({"1000000000.0000001", "-1e10"}, FileProblem::numberOutOfRange, number);
    expectRefusals({"[1000000000.0000001,0]", "[0,-1e300]"}, FileProblem::numberOutOfRange, point);
}

TEST(JsonNode, namesThePlaceOfANumberBeyondTheRangeOfDoubles) {
    const auto error = refusal(R"([{},[0,[7],-1e999]])", [](const JsonNode& node) {
        node.forEachElement([](const JsonNode& element) {
            if (element.place() == "[1]")
                element.forEachElement([](const JsonNode& last) {
                    if (last.place() != "[1][1]")
                        (void)last.number();
                });
        });
    });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->problem, FileProblem::numberOutOfRange);
    EXPECT_EQ(error->place, "[1][2]");
    EXPECT_EQ(problemOf("1e999", [](const JsonNode& node) { (void)node.wholeNumber(0, 9); }),
              FileProblem::expectedWholeNumber);
    EXPECT_EQ(problemOf("[0,1e999]", [](const JsonNode& node) { (void)node.point(); }), FileProblem::numberOutOfRange);
}

TEST(JsonNode, refusesTheEndsOfAnOpenRange) {
    const Read between = [](const JsonNode& node) { (void)node.numberBetween(0, 1); };
    EXPECT_FALSE(refusal("0.9999999999999999", between));
    expectRefusals({"0", "1", "-0.0", "2", "1e999"}, FileProblem::numberOutOfOpenRange, between);
    EXPECT_EQ(problemOf("null", between), FileProblem::expectedNumber);
}

TEST(JsonNode, refusesTextsWithANul) {
    EXPECT_EQ(problemOf(R"("a\u0000b")", [](const JsonNode& node) { (void)node.text(); }), FileProblem::expectedText);
}

TEST(JsonNode, refusesListsThatAreTooLong) {
    const Read points = [](const JsonNode& node) { EXPECT_EQ(node.points(2).size(), 2u); };
    EXPECT_FALSE(refusal("[[1,2],[3,4]]", points));
    const std::optional<FileError> error = refusal("[[1,2],[3,4],[5,6]]", points);
    EXPECT_EQ(error->problem, FileProblem::tooMany);
    EXPECT_EQ(error->numbers, std::vector<double>{2});
}

TEST(JsonNode, refusesIndicesThatAreNoPlainDecimals) {
    for (const std::string_view key :
         {"", "01", "00", "+1", "-1", "-0", " 1", "1 ", "1.0", "1e0", "0x1", "١", "a", "5", "18446744073709551617"}) {
        const std::string text = "{\"" + std::string(key) + "\":0}";
        EXPECT_EQ(problemOf(text, [](const JsonNode& node) { node.forEachIndexed(5, [](int, const JsonNode&) {}); }),
                  FileProblem::noSuchIndex)
            << key;
    }
}

TEST(JsonNode, visitsIndexedMembersInTheOrderOfTheText) {
    std::vector<int> visited;
    const Read collect = [&](const JsonNode& node) {
        node.forEachIndexed(5, [&](int index, const JsonNode& member) {
            visited.push_back(index);
            EXPECT_EQ(member.wholeNumber(0, 9), index);
        });
    };
    EXPECT_FALSE(refusal(R"({"4":4,"0":0,"2":2})", collect));
    EXPECT_EQ(visited, (std::vector{4, 0, 2}));
}

TEST(JsonNode, refusesRepeatedIndicesHoweverTheyAreEscaped) {
    const std::optional<FileError> error =
        refusal(R"({"3":0,"\u0033":0})", [](const JsonNode& n) { n.forEachIndexed({}, [](int, const JsonNode&) {}); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->problem, FileProblem::repeatedKey);
    EXPECT_EQ(error->place, "3");
}

TEST(JsonNode, withoutACountTakesEveryIndexThatACurveMayHave) {
    const Read any = [](const JsonNode& node) { node.forEachIndexed({}, [](int, const JsonNode&) {}); };
    EXPECT_FALSE(refusal(R"({"99999":0})", any));
    EXPECT_EQ(problemOf(R"({"100000":0})", any), FileProblem::noSuchIndex);
}

TEST(JsonObject, refusesUnknownRepeatedAndMissingKeys) {
    const Read object = [](const JsonNode& node) {
        const JsonObject read(node, {"a", "b"});
        EXPECT_EQ(read.find("b"), nullptr);
        EXPECT_EQ(read.require("a").wholeNumber(1, 1), 1);
    };
    EXPECT_FALSE(refusal(R"({"a":1})", object));
    EXPECT_EQ(refusal(R"({"a":1,"c":{}})", object)->place, "c");
    EXPECT_EQ(problemOf(R"({"a":1,"":2})", object), FileProblem::unknownKey);
    EXPECT_EQ(problemOf(R"({"a":1,"A":2})", object), FileProblem::unknownKey);
    EXPECT_EQ(problemOf(R"({"a":1,"\u0061":2})", object), FileProblem::repeatedKey);
    EXPECT_EQ(refusal("{}", object)->words, std::vector<std::string>{"a"});
}

TEST(JsonNode, knowsItsPlace) {
    std::string place;
    EXPECT_FALSE(refusal(R"({"a":[0,{"b":[7]}]})", [&](const JsonNode& root) {
        const JsonObject object(root, {"a"});
        object.require("a").forEachElement([&](const JsonNode& element) {
            if (element.place() == "a[1]") {
                const JsonObject inner(element, {"b"});
                inner.require("b").forEachElement([&](const JsonNode& seven) { place = seven.place(); });
            }
        });
    }));
    EXPECT_EQ(place, "a[1].b[0]");
}

} // namespace
} // namespace kriva
