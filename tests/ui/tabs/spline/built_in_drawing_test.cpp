#include "tests/core/sheets/spline/spline_values.h"
#include "ui/tabs/spline/built_in_drawing.h"

#include <gtest/gtest.h>

namespace kriva::ui {
namespace {

double deviationOf(const SplineCurve& curve, int points) {
    return withoutLimit([&](WorkBudget& budget) { return deviationFromBuiltIn(curve, points, budget); });
}

/// One cubic that rises to 1 half way between (0, 0) and (1, 0), `size` times over at `offset`.
SplineCurve arch(double size = 1, double offset = 0) {
    const auto at = [&](double x, double y) { return Point{offset + size * x, offset + size * y}; };
    SplineCurve curve;
    curve.knots = {test::heldKnot(at(0, 0), SplineKnot::Join::corner, {}, at(0, 4.0 / 3)),
                   test::heldKnot(at(1, 0), SplineKnot::Join::corner, at(1, 4.0 / 3), {})};
    return curve;
}

TEST(BuiltInDrawing, isFarFromTheChordByTheHeightOfTheArch) {
    EXPECT_NEAR(deviationOf(arch(), 2), 1, 1e-3);
    EXPECT_NEAR(deviationOf(arch(1e6), 2), 1e6, 1e3);
    EXPECT_NEAR(deviationOf(arch(1e-3, 1e3), 2), 1e-3, 1e-6);
}

TEST(BuiltInDrawing, isNearerThePolylineTheMorePointsItHas) {
    // Twice the steps, a quarter of the deviation, until Qt's own lines are no finer.
    const double at5 = deviationOf(arch(), 5);
    const double at9 = deviationOf(arch(), 9);
    EXPECT_NEAR(at5 / at9, 4, 0.8);
    EXPECT_LT(deviationOf(arch(), 100), 2e-3);
    EXPECT_GT(deviationOf(arch(), 100), 0) << "Qt's lines are no curve either";
}

TEST(BuiltInDrawing, ofALineIsItsPolyline) {
    SplineCurve line;
    line.knots = {{{0, 0}, {}, {}, {}}, {{3, 1}, {}, {}, {}}};
    EXPECT_LT(deviationOf(line, 2), 1e-12);
    line.knots[1].at = line.knots[0].at;
    EXPECT_EQ(deviationOf(line, 2), 0) << "no extent";
    line.knots.pop_back();
    EXPECT_EQ(deviationOf(line, 2), 0) << "incomplete";
}

TEST(BuiltInDrawing, isThatOfTheCanvasInEveryDegree) {
    for (int degree = 2; degree <= 5; ++degree) {
        SplineCurve curve = arch();
        curve.knots.push_back({{2, 1}, {}, {}, {}});
        curve.degree = degree;
        EXPECT_LT(deviationOf(curve, 100), 3e-3) << degree;
    }
}

} // namespace
} // namespace kriva::ui
