#include "core/polynomial/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kriva {
namespace {

double integral(std::size_t rule, auto f) {
    double sum = 0;
    for (const GaussNode node : gaussNodes(rule))
        sum += node.weight * (f(node.at) + f(1 - node.at));
    return sum;
}

TEST(GaussLegendre, rulesHaveTheirSizesAndRise) {
    const auto& sizes = kGaussSizes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        EXPECT_EQ(2 * gaussNodes(i).size(), static_cast<std::size_t>(sizes[i]));
        EXPECT_TRUE(i == 0 || sizes[i - 1] < sizes[i]);
    }
}

TEST(GaussLegendre, integratesPolynomialsOfTwiceItsSize) {
    for (std::size_t i = 0; i < kGaussSizes.size(); ++i)
        for (const int power : {0, 1, 7, 2 * kGaussSizes[i] - 1})
            EXPECT_NEAR(integral(i, [&](double t) { return std::pow(t, power); }) * (power + 1), 1, 1e-14);
}

TEST(GaussLegendre, centredRulesAreTheSame) {
    for (std::size_t i = 0; i < CentredRule::kSizes.size(); ++i) {
        const CentredRule& rule = centredRule(i);
        EXPECT_EQ(2 * rule.half, static_cast<std::size_t>(CentredRule::kSizes[i]));
        EXPECT_EQ(rule.half % 4, 0);
        for (const int power : {0, 1, 7, 2 * CentredRule::kSizes[i] - 1}) {
            double sum = 0;
            for (std::size_t k = 0; k < rule.half; ++k)
                sum +=
                    rule.weights[k] * (std::pow(0.5 - rule.offsets[k], power) + std::pow(0.5 + rule.offsets[k], power));
            EXPECT_NEAR(sum * (power + 1), 1, 1e-14);
        }
    }
}

TEST(GaussLegendre, meetsThePrintedNodesOfEightPoints) {
    // Abramowitz, Stegun, Handbook of Mathematical Functions, table 25.4, n = 8.
    EXPECT_NEAR(1 - 2 * gaussNodes(0)[0].at, 0.960289856497536, 1e-15);
    EXPECT_NEAR(2 * gaussNodes(0)[0].weight, 0.101228536290376, 1e-15);
    EXPECT_NEAR(1 - 2 * gaussNodes(0)[3].at, 0.183434642495650, 1e-15);
    EXPECT_NEAR(2 * gaussNodes(0)[3].weight, 0.362683783378362, 1e-15);
}

} // namespace
} // namespace kriva
