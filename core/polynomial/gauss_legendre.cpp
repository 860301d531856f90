#include "core/polynomial/gauss_legendre.h"

#include <cassert>
#include <numbers>
#include <utility>

namespace kriva {

namespace {

constexpr long double cosine(long double angle) {
    long double sum = 1;
    long double term = 1;
    // 0 <= angle <= pi / 2: fifteen terms of the series reach the last place.
    for (int k = 1; k <= 30; k += 2)
        sum += term *= -angle * angle / static_cast<long double>(k * (k + 1));
    return sum;
}

/// The k-th positive root of the Legendre polynomial of degree n, counted from 1 downwards, and its weight, by Newton's
/// method. Source: Abramowitz, Stegun, Handbook of Mathematical Functions, 22.16.6 (start), 25.4.29 (weights).
constexpr GaussNode gaussNode(int n, int k) {
    const auto size = static_cast<long double>(n);
    long double x = cosine(std::numbers::pi_v<long double> * (static_cast<long double>(k) + 0.75L) / (size + 0.5L));
    long double slope = 0;
    // From this start four steps reach full precision; two more cost nothing at compile time.
    for (int step = 0; step < 6; ++step) {
        long double before = 1;
        long double value = x;
        for (int j = 2; j <= n; ++j) {
            const auto m = static_cast<long double>(j);
            const long double next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
            before = value;
            value = next;
        }
        slope = size * (x * value - before) / (x * x - 1);
        x -= value / slope;
    }
    // From [-1, 1] to [0, 1]: half the weight 2 / ((1 - x^2) slope^2).
    return {static_cast<double>((1 - x) / 2), static_cast<double>(1 / ((1 - x * x) * slope * slope))};
}

template <int kSize>
constexpr auto makeRule() {
    std::array<GaussNode, kSize / 2> rule;
    for (int k = 0; k < kSize / 2; ++k)
        rule[static_cast<std::size_t>(k)] = gaussNode(kSize, k);
    return rule;
}

template <int kSize>
constexpr auto kRule = makeRule<kSize>();

constexpr std::array<std::span<const GaussNode>, kGaussSizes.size()> kRules{
    kRule<kGaussSizes[0]>, kRule<kGaussSizes[1]>, kRule<kGaussSizes[2]>, kRule<kGaussSizes[3]>, kRule<kGaussSizes[4]>,
    kRule<kGaussSizes[5]>, kRule<kGaussSizes[6]>, kRule<kGaussSizes[7]>, kRule<kGaussSizes[8]>};

template <int kSize>
constexpr CentredRule makeCentredRule() {
    CentredRule rule;
    for (const GaussNode& node : kRule<kSize>) {
        rule.offsets[rule.half] = 0.5 - node.at;
        rule.weights[rule.half++] = node.weight;
    }
    return rule;
}

template <std::size_t... index>
constexpr std::array<CentredRule, sizeof...(index)> makeCentredRules(std::index_sequence<index...>) {
    return {makeCentredRule<CentredRule::kSizes[index]>()...};
}

constexpr auto kCentredRules = makeCentredRules(std::make_index_sequence<CentredRule::kSizes.size()>());

} // namespace

std::span<const GaussNode> gaussNodes(std::size_t index) {
    assert(index < kRules.size());
    return kRules[index];
}

const CentredRule& centredRule(std::size_t index) {
    assert(index < kCentredRules.size());
    return kCentredRules[index];
}

} // namespace kriva
