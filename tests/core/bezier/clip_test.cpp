#include "core/bezier/bounds.h"
#include "core/bezier/clip.h"
#include "core/bezier/evaluate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kriva {
namespace {

const Points kArch{{0, 0}, {1, 3}, {2, 3}, {3, 0}};

TEST(Clipped, givesWhatIsInsideAsItIs) {
    EXPECT_EQ(clipped(kArch, {-1, -1, 4, 4}), (std::vector<Points>{kArch}));
}

TEST(Clipped, givesNothingOfWhatIsElsewhere) {
    EXPECT_TRUE(clipped(kArch, {5, 5, 6, 6}).empty());
    EXPECT_TRUE(clipped(kArch, {1.4, 0.1, 1.6, 0.2}).empty()); // under the arch, inside of its hull
    EXPECT_TRUE(clipped({}, {0, 0, 1, 1}).empty());
}

TEST(Clipped, cutsAtTheSides) {
    const std::vector<Points> parts = clipped(kArch, {0, 0, 3, 1});
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].front(), kArch.front());
    EXPECT_EQ(parts[0].back().y, 1);
    EXPECT_EQ(parts[1].front().y, 1);
    EXPECT_EQ(parts[1].back(), kArch.back());
}

RC_GTEST_PROP(ClippedProperty, coversAllThatIsInside, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(2, 8);
    const auto small = *rc::gen::container<std::vector<std::pair<std::int8_t, std::int8_t>>>(
        count, rc::gen::arbitrary<std::pair<std::int8_t, std::int8_t>>());
    Points curve;
    for (const auto& [x, y] : small)
        curve.push_back({x / 64.0, y / 64.0});
    const Box box{-0.5, -0.7, 0.9, 0.6};
    double inside = 0; // lengths are measured by sampling the same way
    constexpr int kSamples = 2000;
    for (int i = 0; i < kSamples; ++i) {
        const Point p = evaluate(curve, (i + 0.5) / kSamples);
        inside += p.x >= box.xmin && p.x <= box.xmax && p.y >= box.ymin && p.y <= box.ymax ? 1.0 / kSamples : 0;
    }
    std::size_t parts = 0;
    for (const Points& part : clipped(curve, box)) {
        const Box bounds = tightBounds(part);
        RC_ASSERT(bounds.xmin >= box.xmin - 1e-9 && bounds.xmax <= box.xmax + 1e-9);
        RC_ASSERT(bounds.ymin >= box.ymin - 1e-9 && bounds.ymax <= box.ymax + 1e-9);
        RC_ASSERT(part.size() == curve.size());
        ++parts;
    }
    RC_ASSERT(parts > 0 || inside < 5.0 / kSamples);
}

} // namespace
} // namespace kriva
