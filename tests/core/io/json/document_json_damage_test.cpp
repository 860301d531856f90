#include "tests/support/any_document.h"
#include "tests/support/documents.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>

namespace kriva {
namespace {

/// A document with every key of format.md.
std::string everyKey() {
    std::ifstream file(KRIVA_TEST_DATA "/cases/page-example.kriva");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A damaged document is refused, or it is another valid one: then writing loses nothing.
void expectRefusedOrValid(std::string_view text) {
    const auto read = readDocument(text);
    if (const FileError* error = std::get_if<FileError>(&read)) {
        EXPECT_TRUE(error->line > 0 || !error->place.empty() || error->problem == FileProblem::missingKey) << text;
        return;
    }
    const std::string written = writeDocument(std::get<Document>(read));
    EXPECT_EQ(writeDocument(test::documentOf(written)), written) << text;
}

TEST(DamagedDocument, isRefusedWhereverItIsCut) {
    const std::string whole = everyKey();
    ASSERT_FALSE(whole.empty());
    const std::size_t end = whole.rfind('}');
    for (std::size_t size = 0; size <= end; ++size)
        EXPECT_EQ(test::refusalOf(std::string_view(whole).substr(0, size)).problem, FileProblem::notJson) << size;
}

TEST(DamagedDocument, isRefusedOrAnotherOneWithAnyByteChanged) {
    const std::string whole = everyKey();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        for (const char byte : {'\0', '\xff', '0', '9', '-', 'e', '"', '}', ']', ',', ' ', '\\'}) {
            damaged[i] = byte;
            expectRefusedOrValid(damaged);
        }
    }
}

TEST(DamagedDocument, isRefusedOrAnotherOneWithABytePutInOrTakenOut) {
    const std::string whole = everyKey();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        expectRefusedOrValid(std::string(whole).erase(i, 1));
        for (const char byte : {'1', '[', '{', ',', '.'})
            expectRefusedOrValid(std::string(whole).insert(i, 1, byte));
    }
}

RC_GTEST_PROP(DamagedDocument, isRefusedOrAnotherOneWithAPartRepeated, ()) {
    const std::string whole = writeDocument(*test::anyDocument());
    const auto from = *rc::gen::inRange<std::size_t>(0, whole.size());
    const auto size = *rc::gen::inRange<std::size_t>(0, whole.size() - from);
    const auto to = *rc::gen::inRange<std::size_t>(0, whole.size());
    expectRefusedOrValid(std::string(whole).insert(to, whole.substr(from, size)));
}

} // namespace
} // namespace kriva
