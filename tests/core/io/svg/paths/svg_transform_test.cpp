#include "core/io/svg/paths/svg_transform.h"

#include <gtest/gtest.h>

namespace kriva {
namespace {

Point moved(std::string_view transform, Point p) {
    const std::optional<Affine> map = readTransform(transform);
    EXPECT_TRUE(map) << transform;
    return map ? (*map)(p) : Point{};
}

void expectNear(Point a, Point b) {
    EXPECT_NEAR(a.x, b.x, 1e-12);
    EXPECT_NEAR(a.y, b.y, 1e-12);
}

TEST(SvgTransform, readsEveryKind) {
    EXPECT_EQ(moved("", {3, 4}), (Point{3, 4}));
    EXPECT_EQ(moved("matrix(1 2 3 4 5 6)", {1, 1}), (Point{9, 12}));
    EXPECT_EQ(moved("translate(5)", {1, 1}), (Point{6, 1}));
    EXPECT_EQ(moved("translate(5, -2)", {1, 1}), (Point{6, -1}));
    EXPECT_EQ(moved("scale(2)", {1, 3}), (Point{2, 6}));
    EXPECT_EQ(moved(" scale( 2 3 ) ", {1, 3}), (Point{2, 9}));
    expectNear(moved("rotate(90)", {1, 0}), {0, 1});
    expectNear(moved("rotate(90, 1 1)", {2, 1}), {1, 2});
    expectNear(moved("skewX(45)", {0, 2}), {2, 2});
    expectNear(moved("skewY(45)", {2, 0}), {2, 2});
}

TEST(SvgTransform, doesTheLastOfAListFirst) {
    EXPECT_EQ(moved("translate(10) scale(2)", {1, 1}), (Point{12, 2}));
    EXPECT_EQ(moved("scale(2),translate(10)", {1, 1}), (Point{22, 2}));
}

TEST(SvgTransform, refusesWhatBreaksTheGrammar) {
    for (const char* text : {"scale", "scale()", "scale(1", "scale(1,2,3)", "matrix(1 2 3 4 5)", "turn(3)",
                             "rotate(1 2)", "scale(a)", "matrix(1 2 3 4 5 6 7 8 9)", "1"})
        EXPECT_FALSE(readTransform(text)) << text;
}

} // namespace
} // namespace kriva
