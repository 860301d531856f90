#include "core/io/svg/curve_svg.h"
#include "core/sheets/elevation/elevation.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::HasSubstr;
using testing::Not;

const TextSource kCaptionTexts{[](Caption) { return std::string("caption"); }, {}, "en"};

TEST(CurveSvg, isOnePathInMillimetresWithoutPaper) {
    ElevationCurve curve;
    curve.name = "Arch";
    curve.points = {{0, 0}, {0, 3}, {4, 3}, {4, 0}};
    const std::optional<std::string> svg = writeCurveSvg(Curve(curve), 10, kCaptionTexts);
    ASSERT_TRUE(svg);
    EXPECT_THAT(*svg, HasSubstr("<title>Arch</title>"));
    EXPECT_THAT(*svg, HasSubstr(R"(<path id="curve-0" d="M 6,28.5 C 6,-1.5 46,-1.5 46,28.5")"));
    EXPECT_EQ(svg->find("<path"), svg->rfind("<path"));
    for (const char* other : {"<rect", "<circle", "<text", "<metadata"})
        EXPECT_THAT(*svg, Not(HasSubstr(other)));
}

TEST(CurveSvg, isNothingWhereNothingIsDrawnYet) {
    EXPECT_EQ(writeCurveSvg(Curve(ElevationCurve{}), {}, kCaptionTexts), std::nullopt);
    EXPECT_EQ(writeCurveSvg(emptyCurve(test::kCombined), {}, kCaptionTexts), std::nullopt);
}

} // namespace
} // namespace kriva
