#include "core/spline/c2_tangents.h"
#include "tests/core/spline/spline_values.h"

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

} // namespace
} // namespace kriva
