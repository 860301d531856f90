#include "core/sheets/spline/chain/smooth_chain.h"
#include "tests/core/sheets/spline/spline_values.h"

namespace kriva {
namespace {

std::vector<Vector> anyChords(std::size_t atLeast) {
    std::vector<Vector> chords;
    for (const Point p : *test::anyPoints(atLeast))
        chords.push_back(p - Point{});
    return chords;
}

/// Chords have coordinates up to 100, their sums and four tangents a few hundred.
constexpr double kRounding = 1e-12;

RC_GTEST_PROP(C2Tangents, solveTheConditionsOfEveryInnerKnot, (bool isClamped)) {
    const std::vector<Vector> c = anyChords(1);
    std::optional<Vector> end;
    if (isClamped)
        end = *test::anyPoint() - Point{};
    const std::vector<Vector> h = c2Tangents(c, std::nullopt, end);
    const std::size_t n = c.size();
    RC_ASSERT(h.size() == n + 1);
    RC_ASSERT(length(2 * h[0] + h[1] - c[0]) <= kRounding);
    for (std::size_t i = 1; i < n; ++i)
        RC_ASSERT(length(h[i - 1] + 4 * h[i] + h[i + 1] - c[i - 1] - c[i]) <= kRounding);
    RC_ASSERT(length(end ? h[n] - *end : h[n - 1] + 2 * h[n] - c[n - 1]) <= kRounding);
}

RC_GTEST_PROP(C2Tangents, givenEndsStandExactly, ()) {
    const Vector start = *test::anyPoint() - Point{};
    const Vector end = *test::anyPoint() - Point{};
    const std::vector<Vector> h = c2Tangents(anyChords(1), start, end);
    RC_ASSERT(h.front() == start);
    RC_ASSERT(h.back() == end);
}

RC_GTEST_PROP(C2Tangents, aClosedChainHasNoFirstKnot, ()) {
    const std::vector<Vector> c = anyChords(3);
    const std::vector<Vector> h = periodicC2Tangents(c);
    const std::size_t n = c.size();
    RC_ASSERT(h.size() == n + 1);
    RC_ASSERT(h[n] == h[0]);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = (i + n - 1) % n;
        RC_ASSERT(length(h[before] + 4 * h[i] + h[i + 1] - c[before] - c[i]) <= kRounding);
    }
}

TEST(C2Tangents, oneNaturalChordIsStraight) {
    EXPECT_EQ(c2Tangents(std::vector<Vector>{{3, -6}}, {}, {}), (std::vector<Vector>{{1, -2}, {1, -2}}));
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
    const std::vector<Vector> chords = anyChords(1);
    const std::vector<Vector> middles = quadraticMiddles(chords);
    for (std::size_t i = 1; i < chords.size(); ++i)
        RC_ASSERT(length(middles[i] - (chords[i - 1] - middles[i - 1])) <= 1e-11);
}

RC_GTEST_PROP(QuadraticChain, noOtherFirstMiddleBendsLess, ()) {
    const std::vector<Vector> chords = anyChords(1);
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
