#include "core/intersections/chain_links.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using testing::ElementsAre;
using testing::Eq;
using testing::IsEmpty;

const Points kLink{{0, 0}, {1, 1}};
const Points kNoLink{{3, 4}, {3, 4}, {3, 4}};

std::vector<std::optional<std::size_t>> followersIn(const std::vector<Points>& segments, bool closed) {
    return followers({segments, closed});
}

TEST(OnePoint, isASegmentWhoseControlPointsCoincide) {
    EXPECT_TRUE(isOnePoint(kNoLink));
    EXPECT_TRUE(isOnePoint(Points{{3, 4}}));
    EXPECT_FALSE(isOnePoint(Points{{3, 4}, {3, 4}, {3, std::nextafter(4.0, 5.0)}}));
    EXPECT_FALSE(isOnePoint(Points{{3, 4}, {5, 4}, {3, 4}})) << "though it ends where it starts";
}

TEST(Followers, ofAnOpenChainEndWithIt) {
    EXPECT_THAT(followersIn({}, false), IsEmpty());
    EXPECT_THAT(followersIn({kLink}, false), ElementsAre(std::nullopt));
    EXPECT_THAT(followersIn({kLink, kLink, kLink}, false), ElementsAre(Eq(1U), Eq(2U), std::nullopt));
}

TEST(Followers, ofAClosedChainRunAround) {
    EXPECT_THAT(followersIn({}, true), IsEmpty());
    EXPECT_THAT(followersIn({kLink}, true), ElementsAre(Eq(0U))) << "its own";
    EXPECT_THAT(followersIn({kLink, kLink, kLink}, true), ElementsAre(Eq(1U), Eq(2U), Eq(0U)));
}

TEST(Followers, leaveOutSegmentsOfOnePoint) {
    EXPECT_THAT(followersIn({kNoLink, kLink, kNoLink, kNoLink, kLink, kNoLink}, false),
                ElementsAre(Eq(1U), Eq(4U), Eq(4U), Eq(4U), std::nullopt, std::nullopt));
    EXPECT_THAT(followersIn({kNoLink, kLink, kNoLink, kLink, kNoLink}, true),
                ElementsAre(Eq(1U), Eq(3U), Eq(3U), Eq(1U), Eq(1U)));
    EXPECT_THAT(followersIn({kNoLink, kNoLink}, true), ElementsAre(std::nullopt, std::nullopt));
}

RC_GTEST_PROP(Followers, leadThroughAllSegmentsInOrder, ()) {
    const auto areLinks = *rc::gen::container<std::vector<bool>>(rc::gen::arbitrary<bool>());
    const auto closed = *rc::gen::arbitrary<bool>();
    std::vector<Points> segments;
    std::vector<std::size_t> links;
    for (std::size_t i = 0; i < areLinks.size(); ++i) {
        segments.push_back(areLinks[i] ? kLink : kNoLink);
        if (areLinks[i])
            links.push_back(i);
    }
    const auto after = followersIn(segments, closed);
    RC_ASSERT(after.size() == segments.size());
    for (std::size_t k = 0; k < links.size(); ++k) {
        const bool isLast = k + 1 == links.size();
        RC_ASSERT(after[links[k]].has_value() == (closed || !isLast));
        if (after[links[k]])
            RC_ASSERT(*after[links[k]] == links[isLast ? 0 : k + 1]);
    }
}

} // namespace
} // namespace kriva
