#include "core/bezier/elevate.h"
#include "core/bezier/measures/arc_length.h"
#include "core/bezier/subdivide.h"
#include "tests/support/any_curve.h"
#include "tests/support/data_sets.h"
#include "tests/support/reference_length.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <fstream>

namespace kriva {
namespace {

/// In extended precision.
const test::ReferenceLength<long double> lengthInExtended(1e-17L);

/// The numbers of a file that length_references wrote.
std::vector<double> storedLengths(const std::string& name) {
    std::ifstream file(std::string(KRIVA_TEST_DATA "/lengths/").append(name).append(".txt"));
    std::vector<double> lengths;
    for (std::string line; std::getline(file, line);)
        std::from_chars(line.data(), line.data() + line.size(), lengths.emplace_back());
    return lengths;
}

/// How many lengths are farther from the stored ones than allowed.
template <class Allowed>
int countOver(const std::vector<Points>& curves, const std::vector<double>& lengths, Allowed allowed) {
    int over = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
        over += !(std::abs(arcLength(curves[i]) - lengths[i]) <= allowed(lengths[i]));
    return over;
}

constexpr double kPromise = 1e-12;

TEST(ArcLength, ofTwoThousandCubicsIsAsStored) {
    for (const auto& [name, curves] :
         {std::pair("cubics", test::randomCubics()), std::pair("cusps", test::nearCusps())}) {
        const std::vector<double> lengths = storedLengths(name);
        ASSERT_EQ(curves.size(), 1000U);
        ASSERT_EQ(lengths.size(), curves.size()) << name;
        for (const double allowed : {1e-3, 1e-6, 1e-9})
            EXPECT_EQ(countOver(curves, lengths, [=](double) { return allowed; }), 0) << name << ' ' << allowed;
        EXPECT_EQ(countOver(curves, lengths, [](double length) { return kPromise * length; }), 0) << name;
    }
}

TEST(ArcLength, ofHigherDegreesIsRightToTwelveDigits) {
    for (const std::size_t size : {3U, 5U, 6U, 7U, 12U, 31U}) {
        const Points curve = test::randomPoints(44, size);
        EXPECT_NEAR(arcLength(curve) / lengthInExtended(curve), 1, kPromise) << size;
    }
}

TEST(ArcLength, ofPointsIsZeroAndOfLinesTheirDistance) {
    EXPECT_EQ(arcLength(Points{{1, 1}}), 0);
    EXPECT_EQ(arcLength(Points(4, Point{0.1, 1e9})), 0);
    EXPECT_EQ(arcLength(Points(201, Point{0.1, 1e9})), 0);
    EXPECT_EQ(arcLength(Points{{0, 0}, {3, 4}}), 5);
    EXPECT_NEAR(arcLength(elevated(Points{{0, 0}, {3, 4}}, 30)) / 5, 1, kPromise);
}

TEST(ArcLength, ofAParabolaHasItsClosedForm) {
    // (t, t^2): sqrt(5) / 2 + asinh(2) / 4.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0.5, 0}, {1, 1}}), std::sqrt(5.0) / 2 + std::asinh(2.0) / 4, 1e-15);
}

TEST(ArcLength, ofParabolasIsRightWhereverTheirSpeedVanishesInTheComplexPlane) {
    // The speed |t - z|, t from -1 to 1, vanishes at z = x + i y and at its conjugate alone. Between there and the
    // parameters fits an ellipse of any size, so that each Gauss rule is just enough for some of these. A piece may be
    // off by 1e-13, and the promise for the whole leaves room for many pieces.
    const auto integral = [](long double s, long double y) {
        return (s * std::sqrt(s * s + y * y) + y * y * std::asinh(s / y)) / 4;
    };
    for (double x = 0; x <= 6; x += 1.0 / 16)
        for (double y = 1.0 / 32; y <= 6; y += 1.0 / 32) {
            const Points parabola{{0, 0}, {(-x - 1) / 2, y / 2}, {-x, y}};
            const auto length = static_cast<double>(integral(1 - x, y) - integral(-1 - x, y));
            ASSERT_NEAR(arcLength(parabola) / length, 1, 1e-13) << x << ' ' << y;
        }
}

TEST(ArcLength, ofSemicubicalCuspsHasItsClosedForm) {
    // (t^2, t^3): ((4 + 9 t^2)^(3/2) - 8) / 27, with the cusp at the start and, from -1 to 1, in the middle.
    const double half = (std::pow(13.0, 1.5) - 8) / 27;
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}}) / half, 1, kPromise);
    EXPECT_NEAR(arcLength(Points{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}) / (2 * half), 1, kPromise);
    // Cut elsewhere, so that no halving meets the cusp.
    const Points cut = part(Points{{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}, 0.1, 1);
    const double from = (std::pow(4 + 9 * 0.64, 1.5) - 8) / 27;
    EXPECT_NEAR(arcLength(cut) / (half + from), 1, kPromise);
}

TEST(ArcLength, ofLinesThatTurnBackAddsBothWays) {
    // x = t^2 (3 - 4 t) has its peak 1/4 at 1/2 and ends at -1.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {1, 0}, {-1, 0}}), 0.25 + 1.25, 1e-12);
    // The same along a slanted line.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {3, 4}, {-3, -4}}) / 5, 1.5, 1e-12);
    // There and back again: x = 2 t (1 - t).
    EXPECT_NEAR(arcLength(Points{{0, 0}, {1, 0}, {0, 0}}), 1, 1e-12);
    // At degree 6, 60 (t (1 - t))^3 / 64 rises to 60 / 4096 and falls again; it stands still at both ends, too.
    EXPECT_NEAR(arcLength(Points{{0, 0}, {0, 0}, {0, 0}, {3, 0}, {0, 0}, {0, 0}, {0, 0}}) / (2 * 60.0 / 64), 1, 1e-12);
}

TEST(ArcLength, ofPointsRepeatedTenTimes) {
    Points curve(30);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] = i < 10 ? Point{0, 0} : i < 20 ? Point{1, 2} : Point{3, 0};
    EXPECT_NEAR(arcLength(curve) / lengthInExtended(curve), 1, kPromise);
}

TEST(ArcLength, changesNoBitFarFromTheOriginOrAtAnotherScale) {
    const Points curve{{0, 0}, {1, 2}, {0.25, 2.5}, {4, 0.125}};
    Points far = curve;
    Points small = curve;
    Points large = curve;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        far[i] = curve[i] + Vector{1048576, -1048576};
        small[i] = {curve[i].x * 0x1p-400, curve[i].y * 0x1p-400};
        large[i] = {curve[i].x * 0x1p+28, curve[i].y * 0x1p+28};
    }
    EXPECT_EQ(arcLength(far), arcLength(curve));
    EXPECT_EQ(arcLength(small), arcLength(curve) * 0x1p-400);
    EXPECT_EQ(arcLength(large), arcLength(curve) * 0x1p+28);
}

RC_GTEST_PROP(ArcLength, liesBetweenChordAndPolygon, ()) {
    const Points curve = *test::anyCurve(1, 12);
    double polygon = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        polygon += distance(curve[i], curve[i + 1]);
    const double length = arcLength(curve);
    RC_ASSERT(length <= polygon * (1 + kPromise));
    RC_ASSERT(length >= distance(curve.front(), curve.back()) * (1 - kPromise));
}

RC_GTEST_PROP(ArcLength, isTheSumOfTheHalves, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const Halves halves = split(curve, *rc::gen::element(0.1, 0.375, 0.5, 0.9));
    const double length = arcLength(curve);
    RC_ASSERT(std::abs(arcLength(halves.left) + arcLength(halves.right) - length) <= 1e-12 * 12000);
}

RC_GTEST_PROP(ArcLength, isTheSameBackwardsAndElevated, ()) {
    const Points curve = *test::anyCurve(1, 12);
    const double length = arcLength(curve);
    RC_ASSERT(std::abs(arcLength(Points(curve.rbegin(), curve.rend())) - length) <= kPromise * length);
    RC_ASSERT(std::abs(arcLength(elevated(curve, 3)) - length) <= 1e-12 * 12000);
}

TEST(ParameterAtLength, clampsToTheEnds) {
    const Points curve{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_EQ(parameterAtLength(curve, -1), 0);
    EXPECT_EQ(parameterAtLength(curve, 0), 0);
    EXPECT_EQ(parameterAtLength(curve, 100), 1);
    EXPECT_EQ(parameterAtLength(Points{{1, 1}}, 1), 0);
    EXPECT_EQ(parameterAtLength(Points(4, Point{1, 1}), 1), 0);
    EXPECT_NEAR(parameterAtLength(Points{{0, 0}, {3, 4}}, 2), 0.4, 1e-15);
}

TEST(ParameterAtLength, findsTheMiddleOfASymmetricCurve) {
    const Points arch{{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EXPECT_NEAR(parameterAtLength(arch, arcLength(arch) / 2), 0.5, 1e-14);
    const Points cusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
    // At the cusp the length grows like the square of the parameter: half its digits are lost.
    EXPECT_NEAR(parameterAtLength(cusp, arcLength(cusp) / 2), 0.5, 1e-6);
}

RC_GTEST_PROP(ParameterAtLength, isTheInverseOfTheLength, ()) {
    const Points curve = *test::anyCurve(1, 8);
    const double length = arcLength(curve);
    const double share = *test::anyParameter();
    const Points start = part(curve, 0, parameterAtLength(curve, share * length));
    RC_ASSERT(std::abs(arcLength(start) - share * length) <= 1e-12 * 8000);
}

} // namespace
} // namespace kriva
