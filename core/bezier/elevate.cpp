#include "core/bezier/elevate.h"

#include "core/bezier/place_lanes.h"
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

/// One elevation by its formula. The nearer of two neighbours is moved towards the other, so that equal ones give
/// themselves bit for bit.
template <std::size_t size>
[[gnu::always_inline]] inline void elevateOnce(const Point* curve, Point* raised) {
    for (std::size_t i = 1; i < size; ++i) {
        const bool isFirstHalf = 2 * i <= size;
        const std::size_t near = isFirstHalf ? i : i - 1;
        const double share = asDouble(isFirstHalf ? i : size - i) / asDouble(size);
        const Vector v = curve[near] - curve[0];
        raised[i] = curve[0] + (v + share * (curve[isFirstHalf ? i - 1 : i] - curve[0] - v));
    }
}

/// The mean of vectors from one end of a curve of degree 1 to 3, where that end itself is zero, under their weights
/// k steps from that end and r from the other, as many times too large as `all` says. All are whole numbers.
template <std::size_t size>
struct WeightsFromEnd;

template <>
struct WeightsFromEnd<2> {
    static double all(double N) { return N; }
    [[gnu::always_inline]] static PlaceLanes sum(const PlaceLanes* vectors, const Lanes& k, const Lanes&) {
        return k * vectors[1];
    }
};

template <>
struct WeightsFromEnd<3> {
    static double all(double N) { return N * (N - 1); }
    [[gnu::always_inline]] static PlaceLanes sum(const PlaceLanes* vectors, const Lanes& k, const Lanes& r) {
        return 2 * k * r * vectors[1] + k * (k - 1) * vectors[2];
    }
};

template <>
struct WeightsFromEnd<4> {
    static double all(double N) { return N * (N - 1) * (N - 2); }
    [[gnu::always_inline]] static PlaceLanes sum(const PlaceLanes* vectors, const Lanes& k, const Lanes& r) {
        const Lanes triple = 3 * k * r;
        const Lanes pairs = k * (k - 1);
        return triple * (r - 1) * vectors[1] + triple * (k - 1) * vectors[2] + pairs * (k - 2) * vectors[3];
    }
};

/// Works out the points first..last of the raised polygon, measured from the curve's start or from its end.
template <std::size_t size>
[[gnu::always_inline]] inline void elevateFromEnd(std::span<const Point> curve, bool isFromStart, std::size_t first,
                                                  std::size_t last, std::span<Point> raised) {
    const std::size_t N = raised.size() - 1;
    const Point origin = curve.front();
    const Vector end = isFromStart ? Vector{} : curve.back() - origin;
    PlaceLanes vectors[size];
    for (std::size_t j = 0; j < size; ++j)
        vectors[j] = PlaceLanes::at(curve[isFromStart ? j : size - 1 - j] - origin - end);
    const PlaceLanes from = PlaceLanes::at(end);
    const PlaceLanes start = PlaceLanes::at(origin);
    Lanes all;
    spread(WeightsFromEnd<size>::all(asDouble(N)), all);
    Lanes steps{0, 1, 2, 3};
    steps += asDouble(first);
    for (std::size_t i = first; i <= last; i += kLanes, steps += asDouble(kLanes)) {
        const Lanes rest = asDouble(N) - steps;
        const PlaceLanes sum = isFromStart ? WeightsFromEnd<size>::sum(vectors, steps, rest)
                                           : WeightsFromEnd<size>::sum(vectors, rest, steps);
        const PlaceLanes points = start + (from + PlaceLanes{sum.x / all, sum.y / all});
        if (i + kLanes <= last + 1) {
            points.write(&raised[i]);
        } else {
            Point some[kLanes];
            points.write(some);
            std::copy_n(some, last + 1 - i, &raised[i]);
        }
    }
}

template <std::size_t size>
void elevateShort(std::span<const Point> curve, std::span<Point> raised) {
    const std::size_t N = raised.size() - 1;
    if (N == size)
        return elevateOnce<size>(curve.data(), raised.data());
    workByLanes([=]() __attribute__((always_inline)) {
        elevateFromEnd<size>(curve, true, 1, N / 2, raised);
        elevateFromEnd<size>(curve, false, N / 2 + 1, N - 1, raised);
    });
}

void elevateLong(std::span<const Point> curve, std::span<Point> raised) {
    RowBuffer<Vector> vectors(curve.size());
    writeFromStart(curve, vectors.row());
    for (std::size_t i = 1; i + 1 < raised.size(); ++i)
        raised[i] = curve.front() + elevatedVector(vectors.row(), raised.size() - curve.size(), i);
}

} // namespace

void elevate(std::span<const Point> curve, std::span<Point> raised) {
    assert(!curve.empty() && raised.size() >= curve.size());
    if (raised.size() == curve.size()) {
        std::ranges::copy(curve, raised.begin());
        return;
    }
    switch (curve.size()) {
    case 1:
        std::ranges::fill(raised, curve.front());
        return;
    case 2:
        elevateShort<2>(curve, raised);
        break;
    case 3:
        elevateShort<3>(curve, raised);
        break;
    case 4:
        elevateShort<4>(curve, raised);
        break;
    default:
        elevateLong(curve, raised);
    }
    raised.front() = curve.front();
    raised.back() = curve.back();
}

Points elevated(std::span<const Point> curve, int times) {
    assert(!curve.empty() && times >= 0);
    Points points(curve.size() + static_cast<std::size_t>(times));
    elevate(curve, points);
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
