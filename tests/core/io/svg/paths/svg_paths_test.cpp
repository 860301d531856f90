#include "core/curve/limits.h"
#include "core/io/svg/paths/svg_paths.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

std::string around(std::string_view inside) {
    return std::string("<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
                       "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' viewBox='0 0 200 100'>\n")
        .append(inside)
        .append("</svg>");
}

std::vector<ImportedPath> readPaths(std::string_view inside) {
    auto paths = readSvgPaths(around(inside));
    const FileError* error = std::get_if<FileError>(&paths);
    EXPECT_FALSE(error) << inside;
    return error ? std::vector<ImportedPath>() : std::get<std::vector<ImportedPath>>(std::move(paths));
}

Points pointsOfFirst(std::string_view inside) {
    const std::vector<ImportedPath> paths = readPaths(inside);
    return paths.empty() ? Points() : paths.front().path.points;
}

FileError faultOf(std::string_view inside) {
    const auto paths = readSvgPaths(around(inside));
    const FileError* error = std::get_if<FileError>(&paths);
    EXPECT_TRUE(error) << inside;
    return error ? *error : FileError{};
}

TEST(SvgPaths, hasYUpAndOnePathForEachSubpath) {
    const std::vector<ImportedPath> paths = readPaths("<path d='M1 2L3 4M5 6Q7 8 9 10'/>");
    ASSERT_EQ(paths.size(), 2);
    EXPECT_EQ(paths[0].path, (Path{{{1, -2}, {3, -4}}, {1}, false}));
    EXPECT_EQ(paths[1].path, (Path{{{5, -6}, {7, -8}, {9, -10}}, {2}, false}));
}

TEST(SvgPaths, readsTheBasicShapes) {
    EXPECT_EQ(pointsOfFirst("<line x1='1' y1='2' x2='3' y2='4'/>"), (Points{{1, -2}, {3, -4}}));
    EXPECT_EQ(pointsOfFirst("<polyline points='0,0 1,0,1 1'/>"), (Points{{0, 0}, {1, 0}, {1, -1}}));
    EXPECT_EQ(pointsOfFirst("<polygon points='0 0 1 0 1 1'/>"), (Points{{0, 0}, {1, 0}, {1, -1}, {0, 0}}));
    EXPECT_EQ(pointsOfFirst("<rect x='1' y='2' width='3' height='4'/>"),
              (Points{{1, -2}, {4, -2}, {4, -6}, {1, -6}, {1, -2}}));
    const Path circle = readPaths("<circle cx='5' cy='6' r='2'/>").front().path;
    EXPECT_TRUE(circle.isClosed);
    EXPECT_EQ(circle.points.front(), (Point{7, -6}));
    const Path ellipse = readPaths("<ellipse cx='5' cy='6' rx='2' ry='1'/>").front().path;
    EXPECT_NEAR(boxOf(ellipse.points).height(), 2, 1e-3);
    // Round corners: one radius stands for both, and neither is more than half a side.
    EXPECT_EQ(pointsOfFirst("<rect width='10' height='4' rx='1'/>").front(), (Point{1, 0}));
    EXPECT_EQ(pointsOfFirst("<rect width='10' height='4' ry='9' rx='2'/>").front(), (Point{2, 0}));
    EXPECT_TRUE(readPaths("<rect width='4' height='4' rx='2'/>").front().path.isClosed);
}

TEST(SvgPaths, leavesOutWhatHasNoSizeOrIsNotDisplayed) {
    EXPECT_EQ(readPaths("<rect width='0' height='4'/><circle r='0'/><path d=''/><path d='M0 0'/>"
                        "<g display='none'><path d='M0 0h1'/></g><path style='fill:red; display : none' d='M0 0h1'/>"
                        "<defs><path d='M0 0h1'/></defs><symbol><path d='M0 0h1'/></symbol><clipPath><path d='M0 0h1'/>"
                        "</clipPath><inkscape:path d='M0 0h1'/><text>M0 0h1</text><line x2='7'/>")
                  .size(),
              1);
}

TEST(SvgPaths, doesAllTransformsAround) {
    EXPECT_EQ(pointsOfFirst("<g transform='translate(10 20)'><a><path transform='scale(2)' d='M0 0L1 1'/></a></g>"),
              (Points{{10, -20}, {12, -22}}));
}

TEST(SvgPaths, followsUse) {
    const std::string_view inside = "<defs><g id='g'><path id='p' d='M0 0h1'/></g>"
                                    "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0h10'/></symbol></defs>";
    const auto used = [&](std::string_view use) { return pointsOfFirst(std::string(inside).append(use)); };
    EXPECT_EQ(used("<use href='#p' x='5' y='6'/>"), (Points{{5, -6}, {6, -6}}));
    EXPECT_EQ(used("<use xlink:href='#g' transform='scale(3)'/>"), (Points{{0, 0}, {3, 0}}));
    EXPECT_EQ(used("<use href='#s' width='20' height='40'/>"), (Points{{0, -10}, {20, -10}}));
    EXPECT_EQ(faultOf("<use href='#missing'/><use href='other.svg#p'/>").problem, FileProblem::noPaths);
}

TEST(SvgPaths, refusesToGoRoundInCircles) {
    const FileError circle = faultOf("<g id='a'><use href='#a'/></g>");
    EXPECT_EQ(circle.problem, FileProblem::usedTooDeep);
    EXPECT_EQ(circle.line, 2);
    std::string inside = "<defs><path id='x0' d='M0 0h1'/>";
    for (int i = 1; i <= 15; ++i) {
        const std::string before = "<use href='#x" + std::to_string(i - 1) + "'/>";
        inside += "<g id='x" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k)
            inside += before;
        inside += "</g>";
    }
    EXPECT_EQ(faultOf(inside + "</defs><use href='#x15'/>").problem, FileProblem::tooManyUses);
}

/// A path that is used so often, each time by what used it before.
std::string chainOfUses(int uses) {
    std::string inside = "<defs><path id='a0' d='M0 0L1 1'/>";
    for (int i = 1; i < uses; ++i)
        inside += "<use id='a" + std::to_string(i) + "' href='#a" + std::to_string(i - 1) + "'/>";
    return inside + "</defs><use href='#a" + std::to_string(uses - 1) + "'/>";
}

TEST(SvgPaths, takes32UsesInsideEachOtherAndNoMore) {
    EXPECT_EQ(readPaths(chainOfUses(32)).size(), 1);
    const FileError error = faultOf(chainOfUses(33));
    EXPECT_EQ(error.problem, FileProblem::usedTooDeep);
    EXPECT_EQ(error.numbers, std::vector<double>{32});
}

TEST(SvgPaths, takes10000UsesAndNoMore) {
    const std::string path = "<defs><path id='a' d='M0 0L1 1'/></defs>";
    const auto used = [&](int times) {
        std::string inside = path;
        for (int i = 0; i < times; ++i)
            inside += "<use href='#a'/>";
        return inside;
    };
    EXPECT_EQ(readPaths(used(10'000)).size(), 10'000);
    const FileError error = faultOf(used(10'001));
    EXPECT_EQ(error.problem, FileProblem::tooManyUses);
    EXPECT_EQ(error.numbers, std::vector<double>{10'000});
}

TEST(SvgPaths, deepUsesOfDeepGroupsNeedNoDeepStack) {
    const auto groups = [](const std::string& inside) {
        constexpr int kNested = 250;
        std::string text;
        for (int i = 0; i < kNested; ++i)
            text += "<g>";
        text += inside;
        for (int i = 0; i < kNested; ++i)
            text += "</g>";
        return text;
    };
    std::string inside = "<defs><path id='a0' d='M0 0L1 1'/>";
    for (int i = 1; i <= 31; ++i)
        inside += "<g id='a" + std::to_string(i) + "'>" +
                  groups("<use href='#a" + std::to_string(i - 1) + "' x='1'/>") + "</g>";
    EXPECT_EQ(pointsOfFirst(inside + "</defs><use href='#a31'/>"), (Points{{31, 0}, {32, -1}}));
}

TEST(SvgPaths, hasViewportsInside) {
    EXPECT_EQ(
        pointsOfFirst("<svg x='10' y='20' width='100' height='100' viewBox='0 0 10 10'><path d='M0 0h10'/></svg>"),
        (Points{{10, -20}, {110, -20}}));
    EXPECT_EQ(pointsOfFirst("<svg width='100' height='50' viewBox='0 0 10 10' preserveAspectRatio='none'>"
                            "<path d='M0 0L10 10'/></svg>"),
              (Points{{0, 0}, {100, -50}}));
}

TEST(SvgPaths, readsUnitsAndPerCent) {
    EXPECT_EQ(pointsOfFirst("<line x2='1in' y2='50%'/>"), (Points{{0, 0}, {96, -50}}));
    EXPECT_EQ(pointsOfFirst("<line x2='25.4mm' y2=' 3px '/>"), (Points{{0, 0}, {96, -3}}));
    EXPECT_EQ(pointsOfFirst("<line x2='100%' y2='72pt'/>"), (Points{{0, 0}, {200, -96}}));
}

TEST(SvgPaths, takesTheCurvesAloneOfAFigureOfKriva) {
    const std::vector<ImportedPath> paths =
        readPaths("<rect id='paper' width='9' height='9'/><g id='layer-polygon'><path "
                  "d='M0 0h1'/></g><g id='layer-curve'><path d='M0 0h2'/></g>");
    ASSERT_EQ(paths.size(), 1);
    EXPECT_EQ(paths[0].path.points.back(), (Point{2, 0}));
}

TEST(SvgPaths, takesTheNameThatAPersonGave) {
    const std::vector<ImportedPath> paths =
        readPaths("<g inkscape:groupmode='layer' inkscape:label='Layer'><path id='path12' d='M0 0h1'/>"
                  "<g inkscape:label='Leaf'><path d='M0 0h1'/><path inkscape:label='Arc' d='M0 0h1'/></g></g>");
    EXPECT_EQ(paths[0].name, "");
    EXPECT_EQ(paths[1].name, "Leaf");
    EXPECT_EQ(paths[2].name, "Arc");
}

TEST(SvgPaths, knowsItsOwnNamespaceByThePrefixOfItsRoot) {
    const auto paths = readSvgPaths("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:path d='M0 0h1'/></s:svg>");
    EXPECT_EQ(std::get<std::vector<ImportedPath>>(paths).size(), 1);
}

TEST(SvgPaths, namesTheAttributeAndTheLineOfAFault) {
    const auto expect = [](std::string_view inside, const std::string& attribute) {
        const FileError error = faultOf(inside);
        EXPECT_EQ(error.problem, FileProblem::badAttribute) << inside;
        EXPECT_EQ(error.words, std::vector{attribute});
        EXPECT_EQ(error.line, 2);
    };
    expect("<path d='M0 0X'/>", "d");
    expect("<g transform='turn(1)'/>", "transform");
    expect("<line x1='wide'/>", "x1");
    expect("<rect width='1furlong'/>", "width");
    expect("<polygon points='0 0 1'/>", "points");
    expect("<svg viewBox='0 0 -1 1'><path d='M0 0h1'/></svg>", "viewBox");
    expect("<use id='u' href='#u' x='?'/>", "x");
    EXPECT_EQ(faultOf("").problem, FileProblem::noPaths);
    const auto broken = readSvgPaths("<svg>\n<g></svg>");
    EXPECT_EQ(std::get<FileError>(broken).problem, FileProblem::notXml);
}

TEST(SvgPaths, namesTheAttributeThatLeadsTooFar) {
    const auto expect = [](std::string_view inside, const std::string& attribute, int line = 2) {
        const FileError error = faultOf(inside);
        EXPECT_EQ(error.problem, FileProblem::farAttribute) << inside;
        EXPECT_EQ(error.words, std::vector{attribute}) << inside;
        EXPECT_EQ(error.line, line) << inside;
        EXPECT_EQ(error.numbers, (std::vector<double>{-1e9, 1e9}));
    };
    expect("<path d='M0 0L1e10 1'/>", "d");
    expect("<path d='M0 0h1e8' transform='scale(1e3)'/>", "transform");
    expect("<path d='M0 0h1e10' transform='scale(.5)'/>", "d");
    expect("<g transform='scale(1e3)'>\n<path d='M0 0h1e8' transform='scale(2)'/></g>", "transform", 2);
    expect("<g transform='scale(2)'>\n<path d='M0 0h1e8' transform='scale(1e3)'/></g>", "transform", 3);
    expect("<rect width='1' height='2e9'/>", "height");
    expect("<line x2='5e9'/>", "x2");
    expect("<polygon points='0 0 1 1 0 2e9'/>", "points");
    expect("<defs><path id='p' d='M0 0h1'/></defs>\n<use href='#p' y='3e9'/>", "y", 3);
    expect("<svg viewBox='0 0 1e-9 1e-9' width='1' height='1'>\n<path d='M0 0h5'/></svg>", "viewBox", 2);
    EXPECT_EQ(pointsOfFirst("<path d='M0 0h1e10' transform='scale(.1)'/>"), (Points{{0, 0}, {1e9, 0}}));
}

TEST(SvgPaths, takesWhatIsNoCharacterForTheReplacementCharacter) {
    const std::string replaced = "\xEF\xBF\xBD";
    const auto nameOf = [](std::string_view label) {
        return readPaths(std::string("<path inkscape:label='").append(label).append("' d='M0 0h1'/>")).front().name;
    };
    EXPECT_EQ(nameOf("a\xE4"), "a" + replaced);
    EXPECT_EQ(nameOf("&#xD800;b"), replaced + "b");
    EXPECT_EQ(nameOf("&#0;&#1114112;&#99999999999;"), replaced + replaced + replaced);
    EXPECT_EQ(nameOf("\xED\xA0\x80"), replaced);
    EXPECT_EQ(nameOf("\xC0\xAF"), replaced + replaced);
    EXPECT_EQ(nameOf("&#x1F642;&#1082;к"), "\U0001F642кк");
}

TEST(SvgPaths, namesThePlaceOfTheFileBehindBrokenCharacters) {
    const auto broken = readSvgPaths("<svg><path id='\xE4\xE4&#xD800;' d='M0 0X'/></svg>");
    const auto whole = readSvgPaths("<svg><path id='aabbbbbbbb' d='M0 0h1'/><path d='M0 0X'/></svg>");
    EXPECT_EQ(std::get<FileError>(broken).column, 7);
    EXPECT_EQ(std::get<FileError>(whole).column, 41);
    const auto behind = readSvgPaths("<svg><path id='\xE4\xE4&#xD800;' d='M0 0h1'/><path d='M0 0X'/></svg>");
    EXPECT_EQ(std::get<FileError>(behind).column, 41);
}

} // namespace
} // namespace kriva
