#include "core/polynomial/polynomial.h"
#include "tests/core/polynomial/any_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace kriva {
namespace {

std::vector<double> anyNodes(int atMost) {
    std::set<double> nodes;
    const int count = *rc::gen::inRange(1, atMost + 1);
    while (nodes.size() < static_cast<std::size_t>(count))
        nodes.insert(anyNumber(-30, 30));
    return {nodes.begin(), nodes.end()};
}

RC_GTEST_PROP(Interpolate, goesThroughAllValues, ()) {
    const std::vector<double> nodes = anyNodes(30);
    std::vector<DoubleDouble> values;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        values.emplace_back(anyNumber(-10, 10));
    const Polynomial polynomial = interpolate(nodes, values);
    RC_ASSERT(polynomial.degree() == static_cast<int>(nodes.size()) - 1);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        RC_ASSERT(valueAt(polynomial, nodes[i]).toDouble() == values[i].high);
}

RC_GTEST_PROP(Interpolate, doesNotDependOnTheOrderOfTheNodes, ()) {
    const std::vector<double> nodes = anyNodes(20);
    const std::vector<double> turned(nodes.rbegin(), nodes.rend());
    std::vector<DoubleDouble> values;
    for (const double x : nodes)
        values.emplace_back(std::sin(x));
    const std::vector<DoubleDouble> turnedValues(values.rbegin(), values.rend());
    const double x = anyNumber(-30, 30);
    RC_ASSERT(valueAt(interpolate(nodes, values), x).toDouble() ==
              valueAt(interpolate(turned, turnedValues), x).toDouble());
}

TEST(Interpolate, findsTheCubicThrough201EquispacedPoints) {
    // In double arithmetic the sensitivity of this interpolation, some 1e57, would leave no digit.
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    for (int x = -100; x <= 100; ++x) {
        nodes.push_back(x);
        values.emplace_back(static_cast<double>(x) * x * x);
    }
    const Polynomial polynomial = interpolate(nodes, values);
    EXPECT_EQ(valueAt(polynomial, 99.5).toDouble(), 99.5 * 99.5 * 99.5);
    EXPECT_EQ(valueAt(polynomial, -0.5).toDouble(), -0.125);
}

TEST(Interpolate, survivesNodesARoundingApart) {
    const double next = std::nextafter(1.0, 2.0);
    const std::vector<double> nodes{0, 1, next, std::nextafter(next, 2.0), 2};
    const std::vector<DoubleDouble> values{5, 0, 1, 0, 5};
    const Polynomial polynomial = interpolate(nodes, values);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        EXPECT_EQ(valueAt(polynomial, nodes[i]).toDouble(), values[i].high);
}

TEST(SlopesAt, areThoseOfTheParabola) {
    const std::vector<double> nodes{1e6 - 1, 1e6 + 1, 1e6};
    const std::vector<DoubleDouble> values{1, 1, 0};
    const std::vector<double> places{1e6 - 0.5, 1e6, 1e6 + 0.25};
    const std::vector<DoubleDouble> slopes = slopesAt(interpolate(nodes, values), places);
    EXPECT_EQ(slopes, (std::vector<DoubleDouble>{-1, 0, 0.5}));
}

TEST(SlopesAt, areThoseOfALineOfOneRounding) {
    const double next = std::nextafter(1.0, 2.0);
    const std::vector<double> nodes{1, next};
    const std::vector<DoubleDouble> values{0, 3};
    EXPECT_DOUBLE_EQ(slopesAt(interpolate(nodes, values), nodes)[1].high, 3 / (next - 1));
}

} // namespace
} // namespace kriva
