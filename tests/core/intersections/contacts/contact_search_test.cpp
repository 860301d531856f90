#include "core/bezier/subdivide.h"
#include "core/intersections/contacts/contact_search.h"
#include "tests/core/intersections/arcs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace kriva {
namespace {

using test::isAt;
using test::kArch;
using test::kScale;
using test::plainArc;
using testing::Ge;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<Contact> found(const Arc& a, const Arc& b, const std::vector<Contact>& joints = {}) {
    WorkBudget budget;
    std::vector<Contact> contacts;
    ContactSearch(kScale, joints, budget).search(a, b, contacts);
    return contacts;
}

TEST(ContactSearch, findsWhereLinesCross) {
    const Arc line = plainArc(Points{{0, 0}, {4, 4}}), other = plainArc(Points{{0, 1}, {4, 0}});
    EXPECT_THAT(found(line, other), testing::ElementsAre(isAt(0.2, 0.2, 1e-15)));
    EXPECT_THAT(found(line, plainArc(Points{{0, 1}, {0.3, 0.4}})), IsEmpty()) << "which ends before";
    EXPECT_THAT(found(line, plainArc(Points{{1, 0}, {5, 4}})), IsEmpty()) << "parallel";
}

TEST(ContactSearch, appendsWhatItFinds) {
    WorkBudget budget;
    std::vector<Contact> contacts{{2, 2}};
    ContactSearch search(kScale, {}, budget);
    search.search(plainArc(Points{{0, 0}, {4, 4}}), plainArc(Points{{0, 1}, {4, 0}}), contacts);
    search.search(plainArc(Points{{0, 0}, {4, 4}}), plainArc(Points{{0, 2}, {2, 0}}), contacts);
    EXPECT_THAT(contacts, testing::ElementsAre(Contact{2, 2}, isAt(0.2, 0.2), isAt(0.25, 0.5)));
}

TEST(ContactSearch, findsAllContactsOfChebyshevCurves) {
    // (u, T_n(u)) and (T_n(v), v) meet where T_n(T_n(u)) = T_(n^2)(u) = u, at u = cos(2 pi k / (n^2 - 1)) and
    // cos(2 pi k / (n^2 + 1)): n^2 times, and no curves of degree n meet more often (Bezout).
    for (std::size_t n = 2; n <= 5; ++n) {
        const auto isSame = [](double u, double v) { return std::abs(u - v) <= 1e-9; };
        const auto sortedOnce = [&](std::vector<double> values) {
            std::ranges::sort(values);
            const auto repeated = std::ranges::unique(values, isSame);
            values.erase(repeated.begin(), repeated.end());
            return values;
        };
        std::vector<double> expected;
        for (const std::size_t parts : {n * n - 1, n * n + 1})
            for (std::size_t k = 0; 2 * k <= parts; ++k)
                expected.push_back(std::cos(2 * std::numbers::pi * double(k) / double(parts)));
        expected = sortedOnce(std::move(expected)); // 1, and -1 of odd degrees, are of both kinds
        ASSERT_THAT(expected, SizeIs(n * n));
        // A little longer than from -1 to 1, so that all of them are inside.
        const Arc a = plainArc(test::stretched(test::chebyshevCurve(1, n), -0.01, 1.02));
        const Arc b = plainArc(test::stretched(test::chebyshevCurve(n, 1), -0.015, 1.01));
        std::vector<double> places;
        for (const Contact& contact : found(a, b)) {
            EXPECT_LE(gapAt(a, b, contact), kScale.touching);
            places.push_back(evaluate(a, contact.a).at.x);
        }
        // One on the border of two parts may be told for both.
        EXPECT_TRUE(std::ranges::equal(sortedOnce(std::move(places)), expected, isSame)) << n;
    }
}

TEST(ContactSearch, findsBothPlacesHoweverCloseTheyAre) {
    // y = 3 - 12 (t - 1/2)^2
    for (const double depth : {1e-2, 1e-4, 1e-8, 1e-10}) {
        const double away = std::sqrt(depth / 12);
        EXPECT_THAT(found(plainArc(kArch), plainArc(Points{{-1, 3 - depth}, {7, 3 - depth}})),
                    testing::UnorderedElementsAre(testing::Field(&Contact::a, testing::DoubleNear(0.5 - away, 1e-7)),
                                                  testing::Field(&Contact::a, testing::DoubleNear(0.5 + away, 1e-7))))
            << depth;
    }
}

TEST(ContactSearch, findsWhereCurvesTouch) {
    // Neither is cut there, so that it is in the midst of some parts of both.
    const Arc arch = plainArc(part(kArch, 0.1, 1));
    const auto lineAt = [](double y) { return plainArc(Points{{-1, y}, {6, y}}); };
    for (const double y : {3.0, 3 + 0.5e-12, 3 - 0.5e-12}) {
        const std::vector<Contact> contacts = found(arch, lineAt(y));
        ASSERT_THAT(contacts, SizeIs(Ge(1U))) << y;
        for (const Contact& contact : contacts)
            EXPECT_THAT(contact, isAt(4.0 / 9, 3.0 / 7, 1e-6)) << y;
    }
    EXPECT_THAT(found(arch, lineAt(3 + 2e-12)), IsEmpty());
}

TEST(ContactSearch, findsNothingOfCurvesBesideEachOther) {
    for (const double gap : {1e-2, 1e-6, 1e-10}) {
        Points beside = kArch;
        for (Point& p : beside)
            p.y += gap;
        EXPECT_THAT(found(plainArc(Points{{0, 0}, {1, 4}, {3, 4}, {4, 0}}),
                          plainArc(Points{{0, gap}, {1, 4 + gap}, {3, 4 + gap}, {4, gap}})),
                    IsEmpty())
            << gap;
    }
}

TEST(ContactSearch, leavesOutJoints) {
    const Arc corner = plainArc(Points{{0, 0}, {1, 2}, {2, 0}}), next = plainArc(Points{{2, 0}, {3, 2}, {4, 0}});
    EXPECT_THAT(found(corner, next, {{1, 0}}), IsEmpty());
    const Arc before = plainArc(Points{{-2, 0}, {-1, -2}, {0, 0}});
    EXPECT_THAT(found(corner, before, {{0, 1}}), IsEmpty());
    // They are joined at one end and cross elsewhere.
    const Arc across = plainArc(Points{{2, 0}, {0, 0.25}}); // where the corner is at t = 1/16
    EXPECT_THAT(found(corner, across, {{1, 0}}), testing::Contains(isAt(1.0 / 16, 15.0 / 16)));
}

RC_GTEST_PROP(ContactSearch, findsNothingOfAParabolaThatIsCutInTwo, ()) {
    const Points parabola = *test::anyBentCurve(2, 2);
    const auto [left, right] = split(parabola, *rc::gen::inRange(1, 8) / 8.0);
    RC_ASSERT(found(arcOf(left, test::kFrame), arcOf(right, test::kFrame), {{1, 0}}).empty());
}

RC_GTEST_PROP(ContactSearch, tellsPlacesOfBothArcs, ()) {
    const Arc a = *test::anyArc(), b = *test::anyArc();
    for (const Contact& contact : found(a, b)) {
        RC_ASSERT(contact.a >= 0 && contact.a <= 1 && contact.b >= 0 && contact.b <= 1);
        RC_ASSERT(gapAt(a, b, contact) <= 2 * kScale.touching);
    }
}

RC_GTEST_PROP(ContactSearch, hasTheParametersOfTheSegmentsForParts, ()) {
    const auto [from, to] = *test::anyStretch();
    const Arc arch = part(plainArc(kArch), from, to);
    const double t = *rc::gen::inRange(1, 32) / 32.0;
    const Point at = evaluate(plainArc(kArch), t).at;
    const Arc upright = part(plainArc(Points{{at.x, -8}, {at.x, 8}}), 0.25, 1);
    const std::vector<Contact> contacts = found(arch, upright);
    if (from < t && t < to) {
        RC_ASSERT(!contacts.empty());
        for (const Contact& contact : contacts) {
            RC_ASSERT(std::abs(contact.a - t) <= 1e-10);
            RC_ASSERT(std::abs(contact.b - (at.y + 8) / 16) <= 1e-10);
        }
    } else if (t < from || t > to) {
        RC_ASSERT(contacts.empty());
    }
}

TEST(ContactSearch, endsWithItsBudget) {
    const Arc one = plainArc(Points{{0, 0}, {2, 5}, {3, -6}, {7, 3}});
    const Arc other = plainArc(Points{{0, 0}, {2, 5 + 1e-6}, {3, -6}, {7, 3}});
    WorkBudget whole;
    std::vector<Contact> contacts;
    ContactSearch(kScale, {}, whole).search(one, other, contacts);
    WorkBudget half(whole.spent() / 2);
    ContactSearch(kScale, {}, half).search(one, other, contacts);
    EXPECT_EQ(half.end(), WorkEnd::beyondBudget);
    EXPECT_LE(half.spent(), whole.spent());
}

} // namespace
} // namespace kriva
