#include "core/spline/quadratic_chain.h"
#include "tests/core/spline/spline_values.h"

namespace kriva {
namespace {

std::vector<Vector> anyChords() {
    std::vector<Vector> chords;
    for (const Point p : *test::anyPoints(1))
        chords.push_back(p - Point{});
    return chords;
}

/// The sum over the chain of |P0 - 2 P1 + P2|^2 when its first middle point moves by a vector.
double bending(std::span<const Vector> chords, std::span<const Vector> middles, Vector moved) {
    double sum = 0;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const Vector second = chords[i] - 2 * (middles[i] + (i % 2 == 0 ? moved : -moved));
        sum += dot(second, second);
    }
    return sum;
}

RC_GTEST_PROP(QuadraticChain, everyMiddleIsTheMirrorImageOfTheOneBefore, ()) {
    const std::vector<Vector> chords = anyChords();
    const std::vector<Vector> middles = quadraticMiddles(chords);
    for (std::size_t i = 1; i < chords.size(); ++i)
        RC_ASSERT(length(middles[i] - (chords[i - 1] - middles[i - 1])) <= 1e-11);
}

RC_GTEST_PROP(QuadraticChain, noOtherFirstMiddleBendsLess, ()) {
    const std::vector<Vector> chords = anyChords();
    const std::vector<Vector> middles = quadraticMiddles(chords);
    const double least = bending(chords, middles, {});
    for (const Vector moved : {Vector{0.01, 0}, Vector{-0.01, 0}, Vector{0, 0.01}, Vector{0, -0.01}})
        RC_ASSERT(bending(chords, middles, moved) >= least);
}

TEST(QuadraticChain, oneSegmentIsStraight) {
    EXPECT_EQ(quadraticMiddles(std::vector<Vector>{{4, 2}}), (std::vector<Vector>{{2, 1}}));
    EXPECT_TRUE(quadraticMiddles({}).empty());
}

// To and fro by the same chord, the deviations from the midpoints grow by one chord per knot, around their mean.
TEST(QuadraticChain, aHundredThousandEqualStepsGatherNoRoundings) {
    const int n = 100'000;
    std::vector<Vector> chords;
    for (int i = 0; i < n; ++i)
        chords.push_back(i % 2 == 0 ? Vector{0.1, 0} : Vector{-0.1, 0});
    const std::vector<Vector> middles = quadraticMiddles(chords);
    const double largest = 0.1 * n / 2;
    for (const int i : {0, 1, n / 2, n - 1}) {
        const double alternating = 0.1 * ((n - 1) / 2.0 - i);
        const double expected = (i % 2 == 0 ? 0.05 + alternating : -0.05 - alternating);
        EXPECT_NEAR(middles[static_cast<std::size_t>(i)].x, expected, 1e-15 * largest);
    }
}

} // namespace
} // namespace kriva
