#include "core/bezier/elevate.h"
#include "core/bezier/subdivide.h"
#include "core/intersections/contacts/segment_contacts.h"
#include "core/polynomial/sign_changes.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::chebyshevCurve;
using test::isAt;
using test::kArch;
using test::kScale;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

SegmentContacts meet(const Points& a, const Points& b, const std::vector<Contact>& joints = {},
                     const ArcFrame& frame = {}) {
    WorkBudget budget;
    return contactsOf(cuspedArcOf(a, frame), cuspedArcOf(b, frame), joints, kScale, budget);
}

/// The same of curves out of anyCurve().
SegmentContacts meetInFrame(const Points& a, const Points& b) {
    return meet(a, b, {}, test::kFrame);
}

const Points kCusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}}; // at 1/2, where it is at (1/2, 3/4)

TEST(CuspedArc, hasTheCuspsOfItsSegment) {
    EXPECT_THAT(cuspedArcOf(kArch, {}).cusps, IsEmpty());
    EXPECT_THAT(cuspedArcOf(kCusp, {}).cusps, ElementsAre(testing::DoubleNear(0.5, 1e-9)));
    EXPECT_THAT(cuspedArcOf(elevated(kCusp, 2), {}).cusps, ElementsAre(testing::DoubleNear(0.5, 1e-9)));
    EXPECT_THAT(cuspedArcOf(part(kCusp, 0.25, 1), {}).cusps, ElementsAre(testing::DoubleNear(1.0 / 3, 1e-9)));
}

TEST(CuspedArc, hasNoneAtItsEndsNorWhereItIsJustSlow) {
    EXPECT_THAT(cuspedArcOf(Points{{0, 0}, {0, 0}, {1, 0}, {1, 1}}, {}).cusps, IsEmpty());
    EXPECT_THAT(cuspedArcOf(Points{{0, 0}, {1 + 1e-4, 1}, {-1e-4, 1}, {1, 0}}, {}).cusps, IsEmpty());
    EXPECT_THAT(cuspedArcOf(Points(4, Point{1, 1}), {}).cusps, IsEmpty());
}

TEST(CuspedArc, ofAStraightSegmentTurnsAtItsCusp) {
    // x = 4 t - 3 t^2 turns at 2/3.
    EXPECT_THAT(cuspedArcOf(Points{{0, 0}, {2, 0}, {1, 0}}, {}).cusps, ElementsAre(testing::DoubleNear(2.0 / 3, 1e-9)));
}

TEST(CuspedArc, isThatOfTheFrame) {
    const CuspedArc arc = cuspedArcOf(Points{{10, 20}, {14, 28}}, {{10, 20}, 4});
    EXPECT_EQ(arc.arc.back(), (Point{1, 2}));
}

TEST(SegmentContacts, ofChebyshevCurvesAreAsManyAsCanBe) {
    // See ContactSearch: they meet n^2 times.
    for (std::size_t n = 2; n <= 5; ++n) {
        const Points one = test::stretched(chebyshevCurve(1, n), -0.01, 1.02);
        const Points other = test::stretched(chebyshevCurve(n, 1), -0.015, 1.01);
        const SegmentContacts found = meet(one, other);
        EXPECT_THAT(found.common, IsEmpty());
        EXPECT_THAT(found.contacts, SizeIs(n * n)) << n;
        for (const auto [a, b] : found.contacts)
            EXPECT_LE(distance(evaluate(test::plainArc(one), a).at, evaluate(test::plainArc(other), b).at), 1e-12);
    }
    for (std::size_t n = 2; n <= 4; ++n)
        EXPECT_THAT(meet(chebyshevCurve(1, n), chebyshevCurve(n, 1)).contacts, SizeIs(n * n)) << "some at both ends";
}

TEST(SegmentContacts, areThereAtEnds) {
    EXPECT_THAT(meet(kArch, {{2, 3}, {2, 9}}).contacts, ElementsAre(isAt(0.5, 0)));
    EXPECT_THAT(meet(kArch, {{2, 9}, {2, 3}}).contacts, ElementsAre(isAt(0.5, 1)));
    EXPECT_THAT(meet(kArch, {{4, 0}, {7, 5}}).contacts, ElementsAre(isAt(1, 0, 0))) << "end on end";
    EXPECT_THAT(meet(kArch, {{2, 3 + 1e-9}, {2, 9}}).contacts, IsEmpty());
}

TEST(SegmentContacts, areToldOnceWhereAnEndIsTouchedOrCrossed) {
    EXPECT_THAT(meet(kArch, {{2, 3}, {6, 3}}).contacts, ElementsAre(isAt(0.5, 0, 1e-6))) << "along the tangent";
    EXPECT_THAT(meet(kArch, {{2, 3 - 1e-13}, {2, 9}}).contacts, ElementsAre(isAt(0.5, 0))) << "just across";
    EXPECT_THAT(meet({{0, 0}, {4, 0}}, {{0, 0}, {2, 3}, {4, 0}}).contacts, SizeIs(2)) << "both ends";
}

TEST(SegmentContacts, areThereAtACusp) {
    for (const Vector way : {Vector{1, 0}, Vector{1, 0.25}, Vector{0.25, 1}, Vector{0, 1}}) {
        const Point cusp{0.5, 0.75};
        const auto isHere = [](const Contact& contact) {
            return std::abs(contact.a - 0.5) <= 1e-6 && std::abs(contact.b - 0.5) <= 1e-6;
        };
        EXPECT_EQ(std::ranges::count_if(meet(kCusp, {cusp - way, cusp + way}).contacts, isHere), 1)
            << way.x << ' ' << way.y;
    }
}

TEST(SegmentContacts, areNoneAtJoints) {
    const Points next{{4, 0}, {4, -4}, {8, -4}, {8, 0}};
    EXPECT_THAT(meet(kArch, next, {{1, 0}}).contacts, IsEmpty()) << "smoothly joined";
    EXPECT_THAT(meet(next, kArch, {{0, 1}}).contacts, IsEmpty());
    EXPECT_THAT(meet(kArch, next).contacts, SizeIs(1)) << "not joined";
    // A ring of two, joined at both ends.
    EXPECT_THAT(meet(kArch, {{4, 0}, {2, -1}, {0, 0}}, {{1, 0}, {0, 1}}).contacts, IsEmpty());
    // Joined at one end, and crossing elsewhere.
    EXPECT_THAT(meet(kArch, {{4, 0}, {-1, 1}}, {{1, 0}}).contacts, SizeIs(1));
}

TEST(SegmentContacts, areNoneAlongCommonParts) {
    const Points first = part(kArch, 0, 0.75), second = part(kArch, 0.25, 1);
    const SegmentContacts found = meet(first, second);
    EXPECT_THAT(found.contacts, IsEmpty());
    ASSERT_THAT(found.common, SizeIs(1));
    EXPECT_THAT(found.common[0].from, isAt(1.0 / 3, 0));
    EXPECT_THAT(found.common[0].to, isAt(1, 2.0 / 3));
}

TEST(SegmentContacts, areThereBesideCommonParts) {
    // Two parts of one loop lie on each other around its top, and cross at its double point.
    const Points loop{{0, 0}, {6, 4}, {-2, 4}, {4, 0}};
    const double h = std::sqrt(21.0) / 14;
    const SegmentContacts found = meet(part(loop, 0, 0.75), part(loop, 0.25, 1));
    ASSERT_THAT(found.common, SizeIs(1));
    EXPECT_THAT(found.common[0].from, isAt(1.0 / 3, 0));
    EXPECT_THAT(found.common[0].to, isAt(1, 2.0 / 3));
    EXPECT_THAT(found.contacts, ElementsAre(isAt((0.5 - h) / 0.75, (0.25 + h) / 0.75)));
}

TEST(SegmentContacts, ofLinesOnOneLineAreTheCommonPart) {
    const SegmentContacts found = meet({{0, 0}, {4, 2}}, {{6, 3}, {2, 1}});
    EXPECT_THAT(found.contacts, IsEmpty());
    ASSERT_THAT(found.common, SizeIs(1));
    EXPECT_THAT(found.common[0].from, isAt(0.5, 1));
    EXPECT_THAT(found.common[0].to, isAt(1, 0.5));
    EXPECT_THAT(meet({{0, 0}, {4, 2}}, {{4, 2}, {6, 3}}).contacts, SizeIs(1)) << "one after the other";
    EXPECT_THAT(meet({{0, 0}, {4, 2}}, {{4, 2}, {6, 3}}).common, IsEmpty());
}

RC_GTEST_PROP(SegmentContacts, withALineAreWhereTheCurveChangesItsSide, ()) {
    const Points curve = *test::anyCurve(1, 5);
    const Points ends{*test::anyPoint(), *test::anyPoint()};
    const Vector along = ends[1] - ends[0];
    RC_PRE(length(along) > 1);
    // Longer than the curve on both sides.
    const Vector way = 4000 / length(along) * along;
    const Points line{ends[0] - way, ends[0] + way};
    std::vector<double> heights;
    for (const Point p : curve)
        heights.push_back(cross(way, p - ends[0]) / 4000);
    RC_PRE(*std::ranges::max_element(heights) - *std::ranges::min_element(heights) > 1);
    const SegmentContacts found = meetInFrame(curve, line);
    const CuspedArc arc = cuspedArcOf(curve, test::kFrame), other = cuspedArcOf(line, test::kFrame);
    for (const Contact& contact : found.contacts)
        RC_ASSERT(gapAt(arc.arc, other.arc, contact) <= 2 * kScale.touching);
    for (const double t : signChanges(heights))
        RC_ASSERT(std::ranges::any_of(found.contacts, [&](const Contact& contact) {
            return part(arc.arc, std::min(t, contact.a), std::max(t, contact.a)).size() <= 1e-6;
        }));
}

RC_GTEST_PROP(SegmentContacts, areTheSameTheOtherWayRound, ()) {
    const Points a = *test::anyBentCurve(2, 5), b = *test::anyBentCurve(2, 5);
    const SegmentContacts one = meetInFrame(a, b), other = meetInFrame(b, a);
    const SegmentContacts back = meetInFrame(a, Points(b.rbegin(), b.rend()));
    RC_ASSERT(one.common.size() == other.common.size());
    RC_ASSERT(one.contacts.size() == other.contacts.size());
    RC_ASSERT(one.contacts.size() == back.contacts.size());
    for (const Contact& contact : one.contacts) {
        RC_ASSERT(std::ranges::any_of(other.contacts, [&](const Contact& c) {
            return std::abs(c.a - contact.b) <= 1e-5 && std::abs(c.b - contact.a) <= 1e-5;
        }));
        RC_ASSERT(std::ranges::any_of(back.contacts, [&](const Contact& c) {
            return std::abs(c.a - contact.a) <= 1e-5 && std::abs(1 - c.b - contact.b) <= 1e-5;
        }));
    }
}

RC_GTEST_PROP(SegmentContacts, areSeenWhereACurveMeetsOneThroughAnyOfItsPlaces, ()) {
    const Points a = *test::anyBentCurve(2, 5);
    Points b = *test::anyBentCurve(2, 5);
    const double t = *test::anyParameter(), s = *test::anyParameter();
    const Vector move = evaluate(cuspedArcOf(a, {}).arc, t).at - evaluate(cuspedArcOf(b, {}).arc, s).at;
    for (Point& p : b)
        p = p + move;
    const SegmentContacts found = meetInFrame(a, b);
    const Arc one = cuspedArcOf(a, test::kFrame).arc, other = cuspedArcOf(b, test::kFrame).arc;
    const auto isHere = [&](const Contact& contact) {
        return part(one, std::min(t, contact.a), std::max(t, contact.a)).size() <= 1e-5 &&
               part(other, std::min(s, contact.b), std::max(s, contact.b)).size() <= 1e-5;
    };
    RC_ASSERT(!found.common.empty() || std::ranges::any_of(found.contacts, isHere));
}

RC_GTEST_PROP(SegmentContacts, ofPiecesOfOneCurveHaveTheCommonPart, ()) {
    const Points segment = *test::anyBentCurve(2, 4);
    const auto [from, to] = *test::anyStretch();
    const SegmentContacts found = meetInFrame(part(segment, 0, to), elevated(part(segment, from, 1), 1));
    RC_ASSERT(std::ranges::any_of(found.common, [from = from, to = to](const CommonPart& common) {
        return std::abs(common.from.a - from / to) <= 1e-6 && std::abs(common.from.b) <= 1e-6 &&
               std::abs(common.to.a - 1) <= 1e-6 && std::abs(common.to.b - (to - from) / (1 - from)) <= 1e-6;
    }));
}

TEST(SegmentContacts, endWithTheirBudget) {
    Points other{{0, 0}, {2, 5}, {3, -6}, {7, 3}};
    const CuspedArc one = cuspedArcOf(other, {});
    other[1].y += 1e-6;
    const CuspedArc two = cuspedArcOf(other, {});
    WorkBudget whole;
    (void)contactsOf(one, two, {}, kScale, whole);
    for (int share = 0; share < 4; ++share) {
        WorkBudget less(whole.spent() * static_cast<std::uint64_t>(share) / 4);
        (void)contactsOf(one, two, {}, kScale, less);
        EXPECT_EQ(less.end(), WorkEnd::beyondBudget);
        EXPECT_LE(less.spent(), whole.spent() + 10'000);
    }
}

} // namespace
} // namespace kriva
