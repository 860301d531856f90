#include "core/bezier/evaluate.h"
#include "core/curve/limits.h"
#include "core/io/svg/paths/elliptical_arc.h"
#include "core/io/svg/paths/path_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

namespace kriva {
namespace {

std::vector<Path> read(std::string_view data) {
    auto paths = readPathData(data);
    EXPECT_TRUE(std::holds_alternative<std::vector<Path>>(paths)) << data;
    return std::get<std::vector<Path>>(std::move(paths));
}

int columnOfFault(std::string_view data) {
    const auto paths = readPathData(data);
    const FileError* error = std::get_if<FileError>(&paths);
    return error && error->problem == FileProblem::notPathData ? error->column : 0;
}

TEST(PathReader, readsEveryCommandAbsoluteAndRelative) {
    const Points points{{1, 2},  {3, 4}, {9, 4}, {9, 8}, {1, 1}, {2, 2}, {3, 0},
                        {4, -2}, {5, 5}, {6, 6}, {7, 7}, {8, 8}, {9, 9}, {11, 7}};
    const std::vector<Path> expected{{points, {1, 1, 1, 3, 3, 2, 2}, false}};
    EXPECT_EQ(read("M1 2L3 4H9V8C1 1 2 2 3 0S5 5 6 6Q7 7 8 8T11 7"), expected);
    EXPECT_EQ(read("m1 2l2 2h6v4c-8-7-7-6-6-8s2 5 3 6q1 1 2 2t3-1"), expected);
}

TEST(PathReader, takesFurtherArgumentsForTheSameCommandAndLinesAfterAMove) {
    EXPECT_EQ(read("M0,0 1,0 1,1"), read("M0,0L1,0L1,1"));
    EXPECT_EQ(read("m5,5 1,0 1,1"), read("M5,5L6,5L7,6"));
    EXPECT_EQ(read("M0 0Q1 1 2 0 3-1 4 0"), read("M0 0Q1 1 2 0Q3-1 4 0"));
}

TEST(PathReader, readsNumbersWithoutBlanksBetweenThem) {
    EXPECT_EQ(read("M.5.5-1-2+3e1,4E-1"), read("M 0.5 0.5 L -1 -2 L 30 0.4"));
    EXPECT_EQ(read("\n\tM 0 , 0\r\n L 1,1 "), read("M0 0L1 1"));
}

TEST(PathReader, mirrorsOnlyTheControlPointOfACurveOfTheSameKind) {
    EXPECT_EQ(read("M0 0Q5 5 2 2S3 3 4 4").front().points[3], (Point{2, 2}));
    EXPECT_EQ(read("M0 0C1 1 5 5 2 2T4 4").front().points[4], (Point{2, 2}));
    EXPECT_EQ(read("M0 0Q1 1 2 0T4 0T6 0").front().points[5], (Point{5, 1}));
}

TEST(PathReader, closesASubpathAndGoesOnWhereItBegan) {
    const std::vector<Path> paths = read("M1 1h2v2zl5 5M0 0h1");
    ASSERT_EQ(paths.size(), 3);
    EXPECT_EQ(paths[0], (Path{{{1, 1}, {3, 1}, {3, 3}, {1, 1}}, {1, 1, 1}, true}));
    EXPECT_EQ(paths[1], polyline(Points{{1, 1}, {6, 6}}));
    EXPECT_EQ(paths[2], polyline(Points{{0, 0}, {1, 0}}));
    EXPECT_EQ(read("M0 0h1v1L0 0z").front().degrees.size(), 3) << "back already";
    EXPECT_EQ(read("M0 0h1v1zm1 1h1")[1].points.front(), (Point{1, 1})) << "relative to the start";
}

TEST(PathReader, leavesOutWhatDrawsNothing) {
    EXPECT_TRUE(read("").empty());
    EXPECT_TRUE(read(" ").empty());
    EXPECT_TRUE(read("M1 1").empty());
    EXPECT_EQ(read("M1 1M0 0h1M2 2").size(), 1);
    EXPECT_EQ(read("M0 0A5 5 0 0 1 0 0h1"), read("M0 0h1")) << "an arc from a place to itself";
}

TEST(PathReader, namesTheFirstFault) {
    EXPECT_EQ(columnOfFault("L1 1"), 2);
    EXPECT_EQ(columnOfFault("M1 x"), 4);
    EXPECT_EQ(columnOfFault("M1 1 X2"), 7);
    EXPECT_EQ(columnOfFault("M1 1 L2"), 8);
    EXPECT_EQ(columnOfFault("M1 1zz9"), 7);
    EXPECT_EQ(columnOfFault("M1 1L1 nan"), 8);
    EXPECT_EQ(columnOfFault("M1 1L1 1e999"), 8);
    EXPECT_GT(columnOfFault("M1 1L1 1e200"), 0) << "beyond all that can be drawn";
    EXPECT_EQ(columnOfFault("M0 0A1 1 0 2 0 1 1"), 12);
    EXPECT_EQ(columnOfFault("M0 0L+-1 0"), 6);
    const auto later = readPathData("M0 0\nL1 1\nL1");
    EXPECT_EQ(std::get<FileError>(later).line, 3);
}

TEST(PathReader, hasALimitOfPieces) {
    std::string data = "M0 0";
    for (std::size_t i = 0; i < limits::kPointsInSheet; ++i)
        data += "h1";
    EXPECT_TRUE(std::holds_alternative<std::vector<Path>>(readPathData(data)));
    const auto refused = readPathData(data + "h1");
    EXPECT_EQ(std::get<FileError>(refused).problem, FileProblem::tooManyPoints);
}

TEST(PathReader, drawsArcsAsTheStandardSays) {
    // A quarter of a circle around the origin, both ways round and the large way.
    const auto middleOf = [](std::string_view data) {
        const Path path = read(data).front();
        Points all;
        forEachPiece(path, [&](std::span<const Point> piece) { all.push_back(piece.back()); });
        return all[all.size() / 2 - 1];
    };
    const auto expectMiddle = [&](std::string_view data, Point expected) {
        EXPECT_NEAR(middleOf(data).x, expected.x, 1e-12) << data;
        EXPECT_NEAR(middleOf(data).y, expected.y, 1e-12) << data;
    };
    EXPECT_EQ(read("M1 0A1 1 0 0 1 0 1").front().degrees.size(), 3);
    expectMiddle("M1 0A1 1 0 0 1 -1 0", {0, 1});
    expectMiddle("M1 0A1 1 0 0 0 -1 0", {0, -1});
    expectMiddle("M1 0A.1 .1 0 0 1 -1 0", {0, 1}); // too small a radius
    expectMiddle("M1 0A1e-300 1e-300 0 0 1 -1 0", {0, 1});
    EXPECT_EQ(read("M1 0A1 1e-300 0 0 1 -1 0"), read("M1 0L-1 0")) << "as flat as a line";
    expectMiddle("M2 0a2 1 0 1 1 -4 0", {0, 1});
    expectMiddle("M0 2a2 1 90 0 0 0 -4", {1, 0}); // turned
}

/// Any flags, any ellipse through both ends: all points of the cubics lie on it.
RC_GTEST_PROP(EllipticalArc, staysOnItsEllipse, ()) {
    const double radiusX = *rc::gen::inRange(1, 50);
    const double radiusY = *rc::gen::inRange(1, 50);
    const double rotation = *rc::gen::inRange(-360, 360);
    const auto angles = *rc::gen::suchThat(rc::gen::pair(rc::gen::inRange(0, 360), rc::gen::inRange(0, 360)),
                                           [](const auto& two) { return (two.first - two.second) % 180 != 0; });
    const double turn = rotation * std::numbers::pi / 180;
    const auto onEllipse = [&](double degrees) {
        const double a = degrees * std::numbers::pi / 180;
        const Vector own{radiusX * std::cos(a), radiusY * std::sin(a)};
        return Point{3 + std::cos(turn) * own.x - std::sin(turn) * own.y,
                     -7 + std::sin(turn) * own.x + std::cos(turn) * own.y};
    };
    const Point from = onEllipse(angles.first);
    const Point to = onEllipse(angles.second);
    const bool isPositive = *rc::gen::arbitrary<bool>();
    const double sweep = std::fmod((isPositive ? 1 : -1) * (angles.second - angles.first) + 360.0, 360);
    const auto cubics = cubicsOf({radiusX, radiusY, rotation, sweep > 180, isPositive}, from, to);
    RC_ASSERT(cubics.front()[0] == from);
    RC_ASSERT(cubics.back()[3] == to);
    for (const auto& cubic : cubics)
        for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0}) {
            const Vector v = evaluate(cubic, t) - Point{3, -7};
            const double x = (std::cos(turn) * v.x + std::sin(turn) * v.y) / radiusX;
            const double y = (std::cos(turn) * v.y - std::sin(turn) * v.x) / radiusY;
            RC_ASSERT(std::abs(std::hypot(x, y) - 1) < 1.01 * kArcTolerance);
        }
}

} // namespace
} // namespace kriva
