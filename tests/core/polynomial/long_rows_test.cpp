#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace kriva {
namespace {

/// One level of the scheme after the other, as the definition says.
template <class T>
std::vector<T> leftBySteps(std::vector<T>& row, double t) {
    std::vector<T> left;
    for (std::size_t count = row.size(); count > 0; --count) {
        left.push_back(row.front());
        for (std::size_t i = 0; i + 1 < count; ++i)
            row[i] = (1 - t) * row[i] + t * row[i + 1];
    }
    return left;
}

template <class T>
void expectSameSplit(std::vector<T> row, double t) {
    std::vector<T> bySteps = row;
    std::vector<T> left(row.size());
    splitInPlace(std::span(row), std::span(left), t);
    RC_ASSERT(left == leftBySteps(bySteps, t));
    RC_ASSERT(row == bySteps);
}

RC_GTEST_PROP(LongRows, areSplitAsShortOnesToTheLastBit, ()) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 3 * kLongRow);
    const double t = *rc::gen::inRange(-100, 200) / 100.0;
    const auto numbers = *rc::gen::container<std::vector<int>>(2 * size, rc::gen::inRange(-1'000'000, 1'000'000));
    std::vector<double> row;
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < size; ++i) {
        row.push_back(numbers[i] / 7.0);
        vectors.push_back({numbers[2 * i] / 7.0, numbers[2 * i + 1] / 3.0});
    }
    expectSameSplit(row, t);
    expectSameSplit(vectors, t);
}

RC_GTEST_PROP(LongRows, areEvaluatedTogetherAsOneByOneToTheLastBit, ()) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 3 * kLongRow);
    const auto numbers = *rc::gen::container<std::vector<int>>(2 * size, rc::gen::inRange(-1'000'000, 1'000'000));
    const auto places = *rc::gen::container<std::vector<int>>(kTogetherInLongRow, rc::gen::inRange(0, 500));
    std::vector<Vector> row;
    for (std::size_t i = 0; i < size; ++i)
        row.push_back({numbers[2 * i] / 7.0, numbers[2 * i + 1] / 3.0});
    std::array<double, kTogetherInLongRow> ts{};
    std::ranges::transform(places, ts.begin(), [](int place) { return place / 1000.0; });
    const std::span<const Vector> scaled(row);
    const auto together = mirroredValues(scaled, ts);
    for (std::size_t k = 0; k < ts.size(); ++k) {
        const auto alone = mirroredValues(scaled, ts[k]);
        RC_ASSERT(together[k].near == alone.near);
        RC_ASSERT(together[k].far == alone.far);
    }
}

} // namespace
} // namespace kriva
