#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/sign_changes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

/// The product of all t - root.
template <class T>
std::vector<T> withRoots(const std::vector<double>& roots) {
    std::vector<T> coefficients{T(1.0)};
    for (const double root : roots)
        coefficients = product(coefficients, std::vector<T>{T(-root), T(1.0) - T(root)});
    return coefficients;
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected, double error) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], error);
}

TEST(SignChanges, ofConstantsAndZerosAreNone) {
    EXPECT_TRUE(signChanges(std::vector<double>{3}).empty());
    EXPECT_TRUE(signChanges(std::vector<double>{0, 0}).empty());
    EXPECT_TRUE(signChanges(std::vector<double>{0, 0, 0}).empty());
    EXPECT_TRUE(signChanges(std::vector<double>(9, 0.0)).empty());
    EXPECT_TRUE(signChanges(std::vector<double>{1, 2, 0.5, 3, 1}).empty());
}

TEST(SignChanges, leaveOutTheEnds) {
    for (std::size_t degree = 1; degree <= 6; ++degree) {
        std::vector<double> coefficients(degree + 1, 1.0);
        coefficients.front() = 0;
        EXPECT_TRUE(signChanges(coefficients).empty());
        std::ranges::reverse(coefficients);
        EXPECT_TRUE(signChanges(coefficients).empty());
    }
}

TEST(SignChanges, findLinearAndQuadraticRoots) {
    expectNear(signChanges(std::vector<double>{-1, 3}), {0.25}, 1e-16);
    expectNear(signChanges(withRoots<double>({0.25, 0.75})), {0.25, 0.75}, 1e-15);
    expectNear(signChanges(withRoots<double>({0.25, 7})), {0.25}, 1e-15);
}

TEST(SignChanges, countMultipleRootsByTheirParity) {
    EXPECT_TRUE(signChanges(withRoots<double>({0.5, 0.5})).empty());
    EXPECT_TRUE(signChanges(withRoots<double>({0.5, 0.5, 0.3, 0.3})).empty());
    expectNear(signChanges(withRoots<double>({0.3, 0.3, 0.3})), {0.3}, 1e-4);
    expectNear(signChanges(withRoots<double>({0.5, 0.5, 0.5, 0.8})), {0.5, 0.8}, 1e-4);
    expectNear(signChanges(withRoots<DoubleDouble>({0.3, 0.3, 0.3}), 1e-30), {0.3}, 1e-9);
}

TEST(SignChanges, inDoubleDoubleTellCloseRootsApart) {
    const std::vector<double> roots{0.5, 0.5 + 1e-9, 0.5 + 2e-9, 0.75};
    expectNear(signChanges(withRoots<DoubleDouble>(roots), 1e-30), roots, 1e-14);
}

TEST(SignChanges, reachWilkinsonsTwentyRoots) {
    std::vector<double> roots;
    for (int i = 1; i <= 20; ++i)
        roots.push_back(i / 21.0);
    expectNear(signChanges(withRoots<double>(roots)), roots, 1e-9);
}

RC_GTEST_PROP(SignChanges, findSeparateRoots, ()) {
    std::vector<double> roots;
    for (int i = 0; i < 8; ++i)
        if (*rc::gen::arbitrary<bool>())
            roots.push_back(i / 8.0 + *rc::gen::inRange(1, 100) / 1000.0);
    const std::vector<double> found = signChanges(withRoots<double>(roots));
    RC_ASSERT(found.size() == roots.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        RC_ASSERT(std::abs(found[i] - roots[i]) <= 1e-9);
}

} // namespace
} // namespace kriva
