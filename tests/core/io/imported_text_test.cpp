#include "core/io/imported_text.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

constexpr char kMark[] = "\xEF\xBB\xBF";

TEST(ImportedText, tellsPathsFromTables) {
    for (const std::string text : {"<svg/>", " \r\n<svg/>", "M0 0", "\n m1,2"}) {
        EXPECT_TRUE(holdsPaths(text)) << text;
        EXPECT_TRUE(holdsPaths(kMark + text)) << text;
    }
    for (const char* text : {"", "1,2", "x,y\n1,2", "L1 2"})
        EXPECT_FALSE(holdsPaths(text)) << text;
}

TEST(ImportedText, readsEachKind) {
    const std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M0 0L1 -2"/></svg>)";
    for (const std::string& text : {svg, kMark + svg, std::string("M0 0L1 -2"), kMark + std::string("M0 0L1 -2"),
                                    std::string("0 0\n1 2"), kMark + std::string("x;y\n0;0\n1;2")}) {
        const auto read = readImportedText(text);
        const auto* paths = std::get_if<std::vector<ImportedPath>>(&read);
        ASSERT_TRUE(paths) << text;
        ASSERT_EQ(paths->size(), 1u) << text;
        EXPECT_EQ(paths->front().path.points, (Points{{0, 0}, {1, 2}})) << text;
    }
}

TEST(ImportedText, makesAPathOfEachCurveOfATable) {
    const auto read = readImportedText("curve,point,x,y\n0,0,1,2\n4,0,3,4\n");
    const auto& paths = std::get<std::vector<ImportedPath>>(read);
    EXPECT_EQ(paths, (std::vector<ImportedPath>{{{}, {{{1, 2}}, {}, false}, {}}, {{}, {{{3, 4}}, {}, false}, {}}}));
}

TEST(ImportedText, refusesEachKindAtItsOwnPlace) {
    EXPECT_EQ(std::get<FileError>(readImportedText("<svg>")).problem, FileProblem::notXml);
    EXPECT_EQ(std::get<FileError>(readImportedText("M0 0\nL1")).line, 2);
    EXPECT_EQ(std::get<TableError>(readImportedText("1 2\n3")).line, 2);
}

} // namespace
} // namespace kriva
