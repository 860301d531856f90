#include "core/intersections/loops/loop_quotient.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <complex>

namespace kriva {
namespace {

using test::plainArc;

/// A place of the arcs of anyArc(): coordinates up to 1, so that values and derivatives stay below some hundreds.
constexpr double kAllowed = 1e-11;

bool areClose(Vector a, Vector b, double allowed = kAllowed) {
    return length(a - b) <= allowed;
}

LoopPlace placeOf(double t, double s) {
    return {(t + s) / 2 - 0.5, (s - t) * (s - t) / 4};
}

/// A whole number of sixteenths.
double anySixteenths(int low, int high) {
    return *rc::gen::inRange(low, high + 1) / 16.0;
}

/// One of the quotients of arcs, and a rectangle around a place.
struct Rectangle {
    LoopQuotient quotient = loopQuotientOf(*test::anyArc());
    LoopPlace centre{anySixteenths(-8, 8), anySixteenths(0, 4)};
    double u = anySixteenths(0, 4);
    double v = anySixteenths(0, 2);

    [[nodiscard]] LocalQuotient local() const { return around(quotient, centre, u, v); }
    /// Places all over it, its corners too.
    [[nodiscard]] std::vector<LoopPlace> places() const {
        std::vector<LoopPlace> all;
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j)
                all.push_back({centre.u + i / 4.0 * u, centre.v + j / 4.0 * v});
        return all;
    }
};

RC_GTEST_PROP(LoopQuotient, isTheDifferenceOfTwoPlacesByThatOfTheirParameters, ()) {
    const Arc arc = *test::anyArc();
    const auto [t, s] = *test::anyStretch();
    const Vector quotient = (evaluate(arc, s).at - evaluate(arc, t).at) / (s - t);
    RC_ASSERT(areClose(evaluate(loopQuotientOf(arc), placeOf(t, s)).value, quotient));
}

RC_GTEST_PROP(LoopQuotient, isTheDerivativeWhereBothParametersAreOne, ()) {
    const Arc arc = *test::anyArc();
    const double t = *test::anyParameter();
    RC_ASSERT(areClose(evaluate(loopQuotientOf(arc), placeOf(t, t)).value, evaluate(arc, t).velocity));
}

RC_GTEST_PROP(LoopQuotient, isRealForConjugateParameters, ()) {
    // (B(m + i g) - B(m - i g)) / (2 i g) = Im B(m + i g) / g, which is at v = -g^2.
    const Arc arc = *test::anyArc();
    const double m = *test::anyParameter(), g = anySixteenths(1, 16);
    const std::complex<double> t(m, g);
    std::array<std::complex<double>, 6> x, y;
    for (std::size_t i = 0; i <= arc.degree; ++i) {
        x[i] = arc.points[i].x;
        y[i] = arc.points[i].y;
    }
    for (std::size_t r = arc.degree; r > 0; --r)
        for (std::size_t i = 0; i < r; ++i) {
            x[i] = (1.0 - t) * x[i] + t * x[i + 1];
            y[i] = (1.0 - t) * y[i] + t * y[i + 1];
        }
    const Vector quotient{x[0].imag() / g, y[0].imag() / g};
    RC_ASSERT(areClose(evaluate(loopQuotientOf(arc), {m - 0.5, -g * g}).value, quotient, 1e-10));
}

TEST(LoopQuotient, ofALineIsItsChordEverywhere) {
    const LoopQuotient quotient = loopQuotientOf(plainArc(Points{{1, 2}, {4, 6}}));
    for (const LoopPlace place : {LoopPlace{0, 0}, LoopPlace{-0.5, 0.25}, LoopPlace{3, -2}}) {
        const LoopValue here = evaluate(quotient, place);
        EXPECT_EQ(here.value, (Vector{3, 4}));
        EXPECT_EQ(here.byU, Vector());
        EXPECT_EQ(here.byV, Vector());
    }
}

TEST(LoopQuotient, ofOnePointIsZero) {
    const LoopQuotient quotient = loopQuotientOf(plainArc(Points(6, Point{3, 4})));
    EXPECT_EQ(evaluate(quotient, {0.25, 0.125}).value, Vector());
    EXPECT_FALSE(hasNoRoot(around(quotient, {0, 0.125}, 0.5, 0.125), {1, 0}));
}

TEST(LoopQuotient, vanishesWhereTheSegmentMeetsItself) {
    // x = 28 t^3 - 42 t^2 + 18 t is 2 at t = 1/2 -+ sqrt(21) / 14, where y is the same, too.
    const Points loop{{0, 0}, {6, 4}, {-2, 4}, {4, 0}};
    EXPECT_LE(length(evaluate(loopQuotientOf(plainArc(loop)), {0, 21.0 / 196}).value), 1e-14);
}

RC_GTEST_PROP(LoopQuotient, hasTheDerivativesThatItsValuesShow, ()) {
    const Rectangle any;
    const double step = 0x1p-10;
    const auto valueAt = [&](double u, double v) {
        return evaluate(any.quotient, {any.centre.u + u, any.centre.v + v}).value;
    };
    const LoopValue here = evaluate(any.quotient, any.centre);
    // The third derivative by u is below 1e3; by v the quotient is a parabola.
    RC_ASSERT(areClose(here.byU, (valueAt(step, 0) - valueAt(-step, 0)) / (2 * step), 1e-2));
    RC_ASSERT(areClose(here.byV, (valueAt(0, step) - valueAt(0, -step)) / (2 * step), 1e-9));
}

RC_GTEST_PROP(LocalQuotient, isTheSameInDistancesFromItsCentre, ()) {
    const Rectangle any;
    const LocalQuotient local = any.local();
    for (const LoopPlace place : any.places()) {
        const LoopValue far = evaluate(any.quotient, place);
        const LoopValue near = evaluate(local.quotient, {place.u - any.centre.u, place.v - any.centre.v});
        RC_ASSERT(areClose(far.value, near.value));
        RC_ASSERT(areClose(far.byU, near.byU));
        RC_ASSERT(areClose(far.byV, near.byV));
    }
}

RC_GTEST_PROP(LocalQuotient, hasNoRootWhereItSaysSo, ()) {
    const Rectangle any;
    const Vector along{anySixteenths(-16, 16), anySixteenths(-16, 16)};
    if (hasNoRoot(any.local(), along)) {
        const double sign = dot(along, evaluate(any.quotient, any.centre).value);
        for (const LoopPlace place : any.places())
            RC_ASSERT(sign * dot(along, evaluate(any.quotient, place).value) > 0);
    }
}

TEST(LocalQuotient, isSureWhereItsTermsLeaveNoRoot) {
    // Of (t, t^2) from 0 to 1 the quotient is (1, 1 + 2 u).
    const LoopQuotient quotient = loopQuotientOf(plainArc(Points{{0, 0}, {0.5, 0}, {1, 1}}));
    EXPECT_TRUE(hasNoRoot(around(quotient, {0, 0.125}, 0.5, 0.125), {1, 0}));
    EXPECT_TRUE(hasNoRoot(around(quotient, {0, 0.125}, 0.49, 0.125), {0, 1}));
    EXPECT_FALSE(hasNoRoot(around(quotient, {0, 0.125}, 0.51, 0.125), {0, 1}));
    EXPECT_FALSE(hasNoRoot(around(quotient, {0, 0.125}, 0.5, 0.125), {0, 1})) << "a root on the border is kept";
}

RC_GTEST_PROP(LocalQuotient, boundsHowItsDerivativesDeviate, ()) {
    const Rectangle any;
    const LocalQuotient local = any.local();
    const LoopValue centre = evaluate(any.quotient, any.centre);
    const Vector byU = deviationByU(local), byV = deviationByV(local);
    for (const LoopPlace place : any.places()) {
        const LoopValue here = evaluate(any.quotient, place);
        RC_ASSERT(std::abs(here.byU.x - centre.byU.x) <= byU.x + kAllowed);
        RC_ASSERT(std::abs(here.byU.y - centre.byU.y) <= byU.y + kAllowed);
        RC_ASSERT(std::abs(here.byV.x - centre.byV.x) <= byV.x + kAllowed);
        RC_ASSERT(std::abs(here.byV.y - centre.byV.y) <= byV.y + kAllowed);
    }
}

TEST(LocalQuotient, boundsThemNoWiderThanOneTermIs) {
    // One term at a time: u^i v^j deviates by its largest value in the rectangle around 0.
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            LoopQuotient quotient;
            quotient.terms[i][j] = {1, -2};
            const LocalQuotient local = around(quotient, {0, 0}, 0.5, 0.25);
            const auto u = double(i), v = double(j);
            const double byU = i + j > 1 && i > 0 ? u * std::pow(0.5, u - 1) * std::pow(0.25, v) : 0;
            const double byV = i + j > 1 && j > 0 ? v * std::pow(0.5, u) * std::pow(0.25, v - 1) : 0;
            EXPECT_EQ(deviationByU(local), (Vector{byU, 2 * byU})) << i << ' ' << j;
            EXPECT_EQ(deviationByV(local), (Vector{byV, 2 * byV})) << i << ' ' << j;
        }
}

} // namespace
} // namespace kriva
