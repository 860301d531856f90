#include "core/document/conversion.h"
#include "tests/support/any_document.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

RC_GTEST_PROP(Conversion, keepsPointsNameAndStyleInEverySheet, ()) {
    const auto from = *rc::gen::inRange<SheetIndex>(0, kSheetCount);
    const auto to = *rc::gen::inRange<SheetIndex>(0, kSheetCount);
    const Points points = *test::anyPoints();
    CurveStyle style;
    style.color = Color{1, 2, 3};
    const Curve curve = withStyle(renamed(withPointsAdded(emptyCurve(from), points), "Blade"), style);
    const Curve result = converted(curve, to);
    RC_ASSERT(result.index() == to);
    RC_ASSERT(pointsOf(result) == points);
    RC_ASSERT(nameOf(result) == "Blade");
    RC_ASSERT(styleOf(result) == style);
    RC_ASSERT(converted(result, from) == curve);
}

TEST(Conversion, leavesBehindWhatOnlyOneSheetKnows) {
    SubdivisionCurve cut;
    cut.points = {{0, 0}, {1, 1}};
    cut.multiplicity = {1, 3};
    cut.levels = 4;
    cut.view.isShown = false;
    const auto chain = std::get<SplineCurve>(converted(Curve(cut), test::kSpline));
    SplineCurve expected;
    expected.knots = {{{0, 0}, {}, {}, {}}, {{1, 1}, {}, {}, {}}};
    EXPECT_EQ(chain, expected);
    EXPECT_EQ(std::get<SubdivisionCurve>(converted(Curve(chain), test::kSubdivision)).multiplicity,
              (std::vector<int>{1, 1}));
}

TEST(Conversion, ofACurveOfTheSameSheetChangesNothing) {
    SubdivisionCurve cut;
    cut.points = {{0, 0}};
    cut.multiplicity = {3};
    EXPECT_EQ(converted(Curve(cut), test::kSubdivision), Curve(cut));
}

} // namespace
} // namespace kriva
