#include "core/bezier/elevate.h"

#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// Weights this far below the largest one change no sum: they fall faster than geometrically.
constexpr double kNegligible = 0x1p-80;

struct Fraction {
    double numerator;
    double denominator;
};

/// Signed integers become doubles in one instruction, unsigned ones by a branch.
double asDouble(std::size_t count) {
    return static_cast<double>(static_cast<std::ptrdiff_t>(count));
}

/// The mean of the vectors first..last under weights known by their ratios only. `ratio(j)` is weight j + 1 over
/// weight j, which falls with j, as numerator and denominator, `mode` is an index of a largest weight. Going outwards
/// from there, all terms positive, nothing overflows or cancels, and the sum of the weights normalises them. Equal
/// vectors have that mean bit for bit.
template <class Ratio>
Vector weightedMean(std::span<const Vector> vectors, std::size_t first, std::size_t last, std::size_t mode,
                    Ratio ratio) {
    Vector sum;
    double total = 1;
    const auto add = [&](double weight, Vector v) {
        sum = sum + weight * (v - vectors[mode]);
        total += weight;
    };
    double weight = 1;
    for (std::size_t j = mode; j < last && weight > kNegligible; ++j) {
        const Fraction up = ratio(j);
        add(weight *= up.numerator / up.denominator, vectors[j + 1]);
    }
    weight = 1;
    for (std::size_t j = mode; j > first && weight > kNegligible; --j) {
        const Fraction up = ratio(j - 1);
        add(weight *= up.denominator / up.numerator, vectors[j - 1]);
    }
    return vectors[mode] + sum / total;
}

/// Control vector i, 0 < i < n + times, of the curve with these n + 1 control vectors raised `times` times. Its
/// weights are the hypergeometric distribution.
Vector elevatedVector(std::span<const Vector> vectors, std::size_t times, std::size_t i) {
    const std::size_t n = vectors.size() - 1;
    const std::size_t first = i > times ? i - times : 0;
    const std::size_t last = std::min(n, i);
    const std::size_t mode = std::clamp((n + 1) * (i + 1) / (n + times + 2), first, last);
    return weightedMean(vectors, first, last, mode, [&](std::size_t j) {
        return Fraction{asDouble((n - j) * (i - j)), asDouble((j + 1) * (times + j + 1 - i))};
    });
}

/// The value at i/N, 0 < i < N. Its weights are the binomial distribution.
Vector valueAtFraction(std::span<const Vector> vectors, std::size_t i, std::size_t N) {
    const std::size_t n = vectors.size() - 1;
    const std::size_t mode = std::min(n, (n + 1) * i / N);
    return weightedMean(vectors, 0, n, mode, [&](std::size_t j) {
        return Fraction{asDouble((n - j) * i), asDouble((j + 1) * (N - i))};
    });
}

} // namespace

Points elevated(std::span<const Point> curve, int times) {
    assert(!curve.empty() && times >= 0);
    if (times == 0)
        return Points(curve.begin(), curve.end());
    std::vector<Vector> vectors(curve.size());
    writeFromStart(curve, vectors);
    const auto raised = static_cast<std::size_t>(times);
    const std::size_t N = curve.size() - 1 + raised;
    Points points(N + 1, curve.front());
    for (std::size_t i = 1; i < N; ++i)
        points[i] = curve.front() + elevatedVector(vectors, raised, i);
    points.back() = curve.back();
    return points;
}

double elevationGap(std::span<const Point> curve, int times) {
    assert(!curve.empty() && times >= 0);
    const auto raised = static_cast<std::size_t>(times);
    const std::size_t n = curve.size() - 1;
    const std::size_t N = n + raised;
    // Both means keep linear functions, so the chord may be taken away first: what is left is the size of the gap, and
    // the small difference loses no digits.
    std::vector<Vector> vectors(curve.size());
    writeFromStart(curve, vectors);
    const Vector chord = vectors.back();
    for (std::size_t j = 0; j <= n && n > 0; ++j)
        vectors[j] = vectors[j] - static_cast<double>(j) / static_cast<double>(n) * chord;
    double gap = 0;
    for (std::size_t i = 1; i < N; ++i)
        gap = std::max(gap, length(elevatedVector(vectors, raised, i) - valueAtFraction(vectors, i, N)));
    return gap;
}

} // namespace kriva
