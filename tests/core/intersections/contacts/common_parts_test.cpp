#include "core/bezier/elevate.h"
#include "core/bezier/subdivide.h"
#include "core/intersections/contacts/common_parts.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::kArch;
using test::kScale;
using test::plainArc;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<CommonPart> partsOf(const Arc& a, const Arc& b, const std::vector<Contact>& contacts) {
    WorkBudget budget;
    return commonParts(a, b, contacts, kScale, budget);
}

void expectPart(const CommonPart& found, Contact from, Contact to) {
    EXPECT_EQ(found.from, from);
    EXPECT_EQ(found.to, to);
}

TEST(CommonParts, needTwoContacts) {
    const Arc arch = plainArc(kArch);
    EXPECT_THAT(partsOf(arch, arch, {}), IsEmpty());
    EXPECT_THAT(partsOf(arch, arch, {{0, 0}}), IsEmpty());
}

TEST(CommonParts, ofOneCurveAreAllOfIt) {
    const Arc arch = plainArc(kArch), back = plainArc(Points(kArch.rbegin(), kArch.rend()));
    const auto forth = partsOf(arch, arch, {{1, 1}, {0, 0}});
    ASSERT_THAT(forth, SizeIs(1));
    expectPart(forth[0], {0, 0}, {1, 1});
    const auto turned = partsOf(arch, back, {{1, 0}, {0, 1}});
    ASSERT_THAT(turned, SizeIs(1));
    expectPart(turned[0], {0, 1}, {1, 0});
}

TEST(CommonParts, areAsLongAsCanBe) {
    // Contacts in between do not cut them.
    const Arc arch = plainArc(kArch);
    const auto found = partsOf(arch, arch, {{0, 0}, {0.25, 0.25}, {0.5, 0.5}, {1, 1}});
    ASSERT_THAT(found, SizeIs(1));
    expectPart(found[0], {0, 0}, {1, 1});
}

TEST(CommonParts, areNoneOfCurvesThatMeetAtBothEndsOnly) {
    const Arc arch = plainArc(kArch);
    for (const Points& other :
         {Points{{0, 0}, {4, 0}}, Points{{0, 0}, {0, 4 + 1e-9}, {4, 4}, {4, 0}}, Points{{0, 0}, {2, -3}, {4, 0}}})
        EXPECT_THAT(partsOf(arch, plainArc(other), {{0, 0}, {1, 1}}), IsEmpty());
}

TEST(CommonParts, areNoneShorterThanAPlace) {
    const Arc line = plainArc(Points{{0, 0}, {4, 0}});
    const double place = kScale.place / 4;
    EXPECT_THAT(partsOf(line, line, {{0.5, 0.5}, {0.5 + 0.99 * place, 0.5 + 0.99 * place}}), IsEmpty());
    EXPECT_THAT(partsOf(line, line, {{0.5, 0.5}, {0.5 + 1.01 * place, 0.5 + 1.01 * place}}), SizeIs(1));
}

TEST(CommonParts, ofALineDrawnAtAnotherSpeedAreFound) {
    // From (2, 1) to (6, 3), standing still at both ends.
    const Arc line = plainArc(Points{{0, 0}, {4, 2}}), slow = plainArc(Points{{2, 1}, {2, 1}, {6, 3}, {6, 3}});
    const auto found = partsOf(line, slow, {{0.5, 0}, {1, 0.5}});
    ASSERT_THAT(found, SizeIs(1));
    expectPart(found[0], {0.5, 0}, {1, 0.5});
}

TEST(CommonParts, areTwoWhereACurveRunsForthAndBack) {
    // The second runs along the first one up to 1/2, at s = 2 t (1 - t), and back.
    const Arc once = plainArc(Points{{0, 0}, {1, 2}, {2, 0}});
    const Arc twice = plainArc(Points{{0, 0}, {1, 2}, {4.0 / 3, 0}, {1, 2}, {0, 0}});
    const auto found = partsOf(once, twice, {{0, 0}, {0, 1}, {0.5, 0.5}});
    ASSERT_THAT(found, SizeIs(2));
    expectPart(found[0], {0, 0}, {0.5, 0.5});
    expectPart(found[1], {0, 1}, {0.5, 0.5});
}

RC_GTEST_PROP(CommonParts, ofPiecesOfOneCurveAreWhatBothHave, ()) {
    const Points segment = *test::anyBentCurve(2, 4);
    const auto [from, to] = *test::anyStretch();
    const Arc first = arcOf(part(segment, 0, to), test::kFrame);
    const Arc second = arcOf(elevated(part(segment, from, 1), *rc::gen::inRange(0, 2)), test::kFrame);
    const Contact start{from / to, 0}, end{1, (to - from) / (1 - from)};
    RC_PRE(part(first, start.a, 1).size() > 2 * kScale.place);
    const auto found = partsOf(first, second, {end, start});
    RC_ASSERT(found.size() == 1);
    RC_ASSERT(found[0].from == start);
    RC_ASSERT(found[0].to == end);
}

TEST(CommonParts, areNotLookedForOnceTheBudgetHasEnded) {
    const Arc arch = plainArc(kArch);
    WorkBudget none(0);
    EXPECT_THAT(commonParts(arch, arch, {{0, 0}, {1, 1}}, kScale, none), IsEmpty());
    EXPECT_EQ(none.end(), WorkEnd::beyondBudget);
}

} // namespace
} // namespace kriva
