#include "core/bezier/elevate.h"
#include "core/bezier/subdivide.h"
#include "core/intersections/loops/double_points.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <numbers>

namespace kriva {
namespace {

using test::chebyshevCurve;
using test::plainArc;
using testing::IsEmpty;
using testing::SizeIs;

const ContactScale kScale;

SegmentContacts doublePointsOf(std::span<const Point> segment) {
    WorkBudget budget;
    return doublePoints(plainArc(segment), kScale, budget);
}

/// Those of a segment that lies on itself nowhere, ascending.
std::vector<Contact> sortedDoublePoints(std::span<const Point> segment) {
    SegmentContacts found = doublePointsOf(segment);
    EXPECT_THAT(found.common, IsEmpty());
    std::ranges::sort(found.contacts, {}, [](const Contact& contact) { return std::pair(contact.a, contact.b); });
    return found.contacts;
}

void expectSame(const std::vector<Contact>& found, std::vector<Contact> expected, double allowed = 1e-10) {
    std::ranges::sort(expected, {}, [](const Contact& contact) { return std::pair(contact.a, contact.b); });
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].a, expected[i].a, allowed);
        EXPECT_NEAR(found[i].b, expected[i].b, allowed);
    }
}

/// The parameters at which (T_p(u), T_q(u)) meets itself: u = cos(k pi / p + l pi / q) and cos(k pi / p - l pi / q),
/// at both of which T_p is (-1)^k cos(l pi p / q) and T_q is (-1)^l cos(k pi q / p); (p - 1) (q - 1) / 2 places.
std::vector<Contact> chebyshevNodes(int p, int q) {
    std::vector<Contact> nodes;
    for (int k = 1; k < p; ++k)
        for (int l = 1; l < q; ++l) {
            const double first = std::numbers::pi * (double(k) / p + double(l) / q);
            const double second = std::numbers::pi * (double(k) / p - double(l) / q);
            const double a = (1 + std::cos(first)) / 2, b = (1 + std::cos(second)) / 2;
            if (first < std::numbers::pi) // the others are the same ones again
                nodes.push_back({std::min(a, b), std::max(a, b)});
        }
    return nodes;
}

TEST(DoublePoints, areNoneBelowDegreeThree) {
    EXPECT_THAT(sortedDoublePoints(Points{{0, 0}, {1, 1}}), IsEmpty());
    EXPECT_THAT(sortedDoublePoints(Points{{0, 0}, {1, 1}, {0, 2}}), IsEmpty());
    EXPECT_THAT(sortedDoublePoints(Points{{0, 0}, {1, 1}, {0, 0}}), IsEmpty()) << "it turns back";
}

TEST(DoublePoints, ofASymmetricLoopHaveTheirClosedForm) {
    // x = 28 t^3 - 42 t^2 + 18 t = 2 where (t - 1/2) (14 t^2 - 14 t + 2) = 0.
    const double h = std::sqrt(21.0) / 14;
    expectSame(sortedDoublePoints(Points{{0, 0}, {6, 4}, {-2, 4}, {4, 0}}), {{0.5 - h, 0.5 + h}});
}

TEST(DoublePoints, ofChebyshevCurvesAreAllFound) {
    for (const auto& [p, q] : {std::pair(2, 3), {3, 2}, {3, 4}, {4, 3}, {2, 5}, {3, 5}, {4, 5}, {5, 4}}) {
        const std::vector<Contact> nodes = chebyshevNodes(p, q);
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>((p - 1) * (q - 1) / 2));
        expectSame(sortedDoublePoints(chebyshevCurve(std::size_t(p), std::size_t(q))), nodes);
    }
}

TEST(DoublePoints, areSeenAtEveryDegreeOfTheSameCurve) {
    const double h = std::sqrt(21.0) / 14;
    for (const int times : {1, 2})
        expectSame(sortedDoublePoints(elevated(Points{{0, 0}, {6, 4}, {-2, 4}, {4, 0}}, times)), {{0.5 - h, 0.5 + h}});
    expectSame(sortedDoublePoints(elevated(chebyshevCurve(3, 4), 1)), chebyshevNodes(3, 4));
}

TEST(DoublePoints, ofALoopHoweverSmallAreTwoParameters) {
    // A cusp opened: x = 1/2 + (4 + 6 by) w^3 - 3/2 by w with w = t - 1/2, and y is even in w.
    for (const double by : {1.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
        const double h = std::sqrt(0.75 * by / (2 + 3 * by));
        const Points cubic{{0, 0}, {1 + by, 1}, {-by, 1}, {1, 0}};
        expectSame(sortedDoublePoints(cubic), {{0.5 - h, 0.5 + h}}, 1e-8);
        expectSame(sortedDoublePoints(elevated(cubic, 1)), {{0.5 - h, 0.5 + h}}, 1e-7);
    }
}

TEST(DoublePoints, areNoneAtACusp) {
    for (const int times : {0, 1, 2}) {
        EXPECT_THAT(sortedDoublePoints(elevated(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, times)), IsEmpty()) << times;
        EXPECT_THAT(sortedDoublePoints(elevated(Points{{0.3, 0.1}, {1.3, 1.1}, {0.3, 1.1}, {1.3, 0.1}}, times)),
                    IsEmpty())
            << times;
    }
}

TEST(DoublePoints, areNoneWhereOnlyComplexParametersMeet) {
    // (u^2, u (u^2 + 1)), u from -1 to 1, has its double point at u = -+i.
    const Points cubic{{1, -2}, {-1.0 / 3, 2.0 / 3}, {-1.0 / 3, -2.0 / 3}, {1, 2}};
    EXPECT_THAT(sortedDoublePoints(cubic), IsEmpty());
    EXPECT_THAT(sortedDoublePoints(elevated(cubic, 2)), IsEmpty());
}

TEST(DoublePoints, areNoneOutsideOfTheSegment) {
    // The loop closes before the start of its later part.
    const Points later = part(Points{{0, 0}, {6, 4}, {-2, 4}, {4, 0}}, 0.2, 1);
    EXPECT_THAT(sortedDoublePoints(later), IsEmpty());
    EXPECT_THAT(sortedDoublePoints(elevated(later, 1)), IsEmpty());
}

TEST(DoublePoints, ofARingAreItsEnds) {
    for (const Points& ring : {Points{{0, 0}, {2, 0}, {0, 2}, {0, 0}}, Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}})
        expectSame(sortedDoublePoints(ring), {{0, 1}}, 0);
}

TEST(DoublePoints, whereASegmentTouchesItselfAreOne) {
    const double h = std::sqrt(1.0 / 12);
    const std::vector<Contact> found = sortedDoublePoints(Points{{0, 3}, {3, 0}, {1, 3}, {0, 2}, {3, 1}});
    ASSERT_THAT(found, SizeIs(2));
    const auto touch = std::ranges::find_if(found, [&](const Contact& c) { return std::abs(c.a + c.b - 1) < 1e-6; });
    ASSERT_NE(touch, found.end());
    EXPECT_NEAR(touch->a, 0.5 - h, 1e-6);
    EXPECT_NEAR(touch->b, 0.5 + h, 1e-6);
}

TEST(DoublePoints, ofAParabolaTracedForthAndBackAreAStretch) {
    // (q, q^2) with q = (t - m)^2 lies on itself as far as both sides of m reach.
    for (const double m : {0.5, 0.25, 0.625}) {
        const double m2 = m * m;
        const std::array powers{Vector{m2, m2 * m2}, Vector{-2 * m, -4 * m2 * m}, Vector{1, 6 * m2}, Vector{0, -4 * m},
                                Vector{0, 1}};
        Points quartic;
        for (std::size_t i = 0; i <= 4; ++i) { // Bernstein coefficient i of t^k is C(i, k) / C(4, k)
            Point p;
            double share = 1;
            for (std::size_t k = 0; k <= i; ++k) {
                p = p + share * powers[k];
                share *= double(i - k) / double(4 - k);
            }
            quartic.push_back(p);
        }
        const SegmentContacts found = doublePointsOf(quartic);
        EXPECT_THAT(found.contacts, IsEmpty());
        ASSERT_THAT(found.common, SizeIs(1)) << m;
        const auto [from, to] = found.common[0];
        const double reach = std::min(m, 1 - m);
        EXPECT_LT(from.a, to.a);
        EXPECT_NEAR(from.a, m - reach, 1e-9);
        EXPECT_NEAR(from.b, m + reach, 1e-9);
        EXPECT_NEAR(to.a, m, 1e-9);
        EXPECT_NEAR(to.b, m, 1e-9);
    }
}

TEST(DoublePoints, ofCubicsAreThereWhereTheirFamilyHasALoop) {
    // Every cubic is an affine image of one with the points (0, 0), (0, 1), (1, 1) and (x, y). Source: Stone, DeRose, A
    // geometric characterization of parametric cubic curves, ACM TOG 8 (1989), figure 6: it has a loop below the
    // parabola of the cusps and above the curves on which the loop closes at an end.
    int loops = 0;
    for (double x = -4; x <= 2; x += 0.171875)
        for (double y = -10; y <= 2; y += 0.171875) {
            const double cusp = (-x * x + 2 * x + 3) / 4;
            const double atEnd = x <= 0 ? (3 * x - x * x) / 3 : (std::sqrt(3 * (4 * x - x * x)) - x) / 2;
            if (std::abs(y - cusp) < 1e-3 || std::abs(y - atEnd) < 1e-3 || std::abs(x - 1) < 1e-3)
                continue;
            const bool isLoop = x < 1 && y < cusp && y > atEnd;
            loops += isLoop;
            ASSERT_EQ(sortedDoublePoints(Points{{0, 0}, {0, 1}, {1, 1}, {x, y}}).size(), isLoop ? 1U : 0U)
                << x << ' ' << y;
        }
    EXPECT_GT(loops, 100);
}

RC_GTEST_PROP(DoublePoints, areWhereTheSegmentIsTwice, ()) {
    const Arc arc = *test::anyArc(3);
    WorkBudget budget;
    for (const auto [t, s] : doublePoints(arc, kScale, budget).contacts) {
        RC_ASSERT(0 <= t && t < s && s <= 1);
        RC_ASSERT(distance(evaluate(arc, t).at, evaluate(arc, s).at) <= kScale.touching);
    }
}

RC_GTEST_PROP(DoublePoints, areTheSameBackwardsAndInAnotherFrame, ()) {
    Points segment = *test::anyBentCurve(3, 5);
    const auto count = [](const Points& points) {
        WorkBudget budget;
        return doublePoints(arcOf(points, test::kFrame), kScale, budget).contacts.size();
    };
    const std::size_t found = count(segment);
    RC_ASSERT(count(Points(segment.rbegin(), segment.rend())) == found);
    for (Point& p : segment)
        p = {p.y, -p.x};
    RC_ASSERT(count(segment) == found);
}

TEST(DoublePoints, endWithTheirBudget) {
    // Looked for long, for the segment nearly lies on itself.
    const Points folded{{0, 0}, {4, 1e-9}, {0, 3}, {1e-9, 3}, {8, 0}, {0, 0}};
    WorkBudget whole;
    (void)doublePoints(plainArc(folded), kScale, whole);
    WorkBudget half(whole.spent() / 2);
    (void)doublePoints(plainArc(folded), kScale, half);
    EXPECT_EQ(half.end(), WorkEnd::beyondBudget);
    EXPECT_LE(half.spent(), whole.spent());
}

} // namespace
} // namespace kriva
