#include "core/curve/limits.h"
#include "core/io/json/fragment.h"
#include "tests/support/any_document.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

using Content = Fragment::Content;

FileError refusalOfFragment(std::string_view text) {
    const auto read = readFragment(text);
    if (const FileError* error = std::get_if<FileError>(&read))
        return *error;
    ADD_FAILURE() << "not refused: " << text;
    return {};
}

SplineCurve corners() {
    SplineCurve curve;
    curve.name = "Corners";
    for (int i = 0; i < 4; ++i) {
        const double x = i;
        curve.knots.push_back({{x, 0}, SplineKnot::Join::corner, Point{x - 0.25, 1}, Point{x + 0.25, 1}});
    }
    return curve;
}

RC_GTEST_PROP(Fragment, comesBackBitForBit, ()) {
    const Document document = *test::anyDocument();
    for (const Sheet& sheet : document.sheets) {
        for (const Curve& curve : sheet.curves) {
            const Fragment fragment{*rc::gen::element(Content::points, Content::curve), curve};
            const auto read = readFragment(writeFragment(fragment));
            RC_ASSERT(std::get<Fragment>(read) == fragment);
        }
    }
}

TEST(Fragment, ofPointsHoldsThemWithAllThatBelongsToThem) {
    const std::vector<int> chosen{1, 3};
    const Fragment fragment = fragmentOf(Curve(corners()), chosen);
    EXPECT_EQ(fragment.content, Content::points);
    const auto& points = std::get<SplineCurve>(fragment.curve);
    ASSERT_EQ(points.knots.size(), 2u);
    EXPECT_EQ(points.knots[0], corners().knots[1]);
    EXPECT_EQ(points.knots[1], corners().knots[3]);
}

TEST(Fragment, isRefusedWithThePlaceOfTheFault) {
    EXPECT_EQ(refusalOfFragment("hello").problem, FileProblem::notJson);
    EXPECT_EQ(refusalOfFragment(R"({"format":"kriva","version":1})").problem, FileProblem::foreignFormat);
    EXPECT_EQ(refusalOfFragment(R"({"format":"kriva-fragment","version":2})").problem, FileProblem::unknownVersion);
    const auto with = [](std::string_view rest) {
        return std::string(R"({"format":"kriva-fragment","version":1,"content":"curve",)").append(rest).append("}");
    };
    EXPECT_EQ(refusalOfFragment(with(R"("sheet":"sphere","curve":{})")).place, "sheet");
    EXPECT_EQ(refusalOfFragment(with(R"("sheet":"spline")")).problem, FileProblem::missingKey);
    EXPECT_EQ(refusalOfFragment(with(R"("sheet":"spline","curve":{"knots":[{"at":[0,0]},{"at":[0,2e9]}]})")).place,
              "curve.knots[1].at");
    EXPECT_EQ(refusalOfFragment(with(R"("sheet":"elevation","curve":{"knots":[]})")).problem, FileProblem::unknownKey);
}

TEST(Fragment, beyondTheLimitsOfADocumentIsRefused) {
    ElevationCurve curve;
    curve.points.assign(limits::kControlPoints + 1, {1, 2});
    const FileError error = refusalOfFragment(writeFragment({Content::curve, Curve(curve)}));
    EXPECT_EQ(error.problem, FileProblem::tooMany);
    EXPECT_EQ(error.numbers, std::vector<double>{201});
    EXPECT_EQ(refusalOfFragment(std::string(limits::kFileBytes + 1, ' ')).problem, FileProblem::tooLarge);
}

} // namespace
} // namespace kriva
