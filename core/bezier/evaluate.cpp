#include "core/bezier/evaluate.h"

#include "core/bezier/place_lanes.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// De Casteljau's scheme on a row whose size the compiler knows, so that it stays in registers.
template <std::size_t size, class EntryAt>
[[gnu::always_inline]] inline Vector valueOfShortRow(double t, EntryAt entryAt) {
    std::array<Vector, size> row;
    for (std::size_t i = 0; i < size; ++i)
        row[i] = entryAt(i);
    return valueInPlace(std::span<Vector>(row), t);
}

template <class EntryAt>
[[gnu::noinline]] Vector valueOfAnyRow(std::size_t size, double t, EntryAt entryAt) {
    RowBuffer<Vector> buffer(size);
    for (std::size_t i = 0; i < size; ++i)
        buffer.row()[i] = entryAt(i);
    return valueInPlace(buffer.row(), t);
}

/// The value at t of the row with these entries.
template <class EntryAt>
[[gnu::always_inline]] inline Vector valueOfRow(std::size_t size, double t, EntryAt entryAt) {
    switch (size) {
    case 1:
        return entryAt(0);
    case 2:
        return valueOfShortRow<2>(t, entryAt);
    case 3:
        return valueOfShortRow<3>(t, entryAt);
    case 4:
        return valueOfShortRow<4>(t, entryAt);
    case 5:
        return valueOfShortRow<5>(t, entryAt);
    case 6:
        return valueOfShortRow<6>(t, entryAt);
    default:
        return valueOfAnyRow(size, t, entryAt);
    }
}

// The middle binomial coefficient of the highest degree is a double, times any coordinate too.
constexpr std::size_t kLongest = 950;

/// Where values are measured from, and where the curve ends, which the way back from vectors would round.
struct EndLanes {
    PlaceLanes start;
    PlaceLanes end;

    [[gnu::always_inline]] explicit EndLanes(std::span<const Point> curve)
        : start(PlaceLanes::at(curve.front()))
        , end(PlaceLanes::at(curve.back())) {}
    [[gnu::always_inline]] PlaceLanes placeOf(const Lanes& t, const PlaceLanes& value) const {
        const PlaceLanes place = start + value;
        return {t == 0 ? start.x : t == 1 ? end.x : place.x, t == 0 ? start.y : t == 1 ? end.y : place.y};
    }
};

/// Works out four values at a time, the last ones with the last parameter of all repeated.
template <class ValueAt>
[[gnu::always_inline]] inline void inFours(std::span<const Point> curve, std::span<const double> ts, Point* points,
                                           const ValueAt& valueAt) {
    const EndLanes ends(curve);
    std::size_t k = 0;
    Lanes t;
    for (; k + kLanes <= ts.size(); k += kLanes) {
        load(ts.data() + k, t);
        ends.placeOf(t, valueAt(t)).write(points + k);
    }
    if (k == ts.size())
        return;
    double rest[kLanes];
    Point last[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i)
        rest[i] = ts[std::min(k + i, ts.size() - 1)];
    load(rest, t);
    ends.placeOf(t, valueAt(t)).write(last);
    std::copy_n(last, ts.size() - k, points + k);
}

/// De Casteljau's scheme, of which the first vector is zero.
template <std::size_t size>
void evaluateShort(std::span<const Point> curve, std::span<const double> ts, Point* points) {
    workByLanes([&]() __attribute__((always_inline)) {
        PlaceLanes controls[size];
        for (std::size_t i = 1; i < size; ++i)
            controls[i] = PlaceLanes::at(curve[i] - curve[0]);
        inFours(
            curve, ts, points, [&](const Lanes& t) __attribute__((always_inline)) {
                const Lanes s = 1 - t;
                PlaceLanes row[size];
                row[0] = t * controls[1];
                for (std::size_t i = 1; i + 1 < size; ++i)
                    row[i] = s * controls[i] + t * controls[i + 1];
                for (std::size_t count = size - 2; count > 0; --count)
                    for (std::size_t i = 0; i < count; ++i)
                        row[i] = s * row[i] + t * row[i + 1];
                return row[0];
            });
    });
}

/// The sum of (1 - t)^(n - i) t^i C(n, i) b_i by Horner's scheme: all weights positive, so that each vector bears the
/// roundings of its own weight alone. The first vector is zero.
void evaluateLong(std::span<const Point> curve, std::span<const double> ts, Point* points) {
    RowBuffer<Vector> buffer(curve.size());
    const std::span<Vector> scaled = buffer.row();
    writeFromStart(curve, scaled);
    scaleByBinomials(scaled);
    workByLanes([&]() __attribute__((always_inline)) {
        inFours(
            curve, ts, points, [&](const Lanes& t) __attribute__((always_inline)) {
                const Lanes s = 1 - t;
                Lanes power = t;
                PlaceLanes sum{};
                for (const Vector v : scaled.subspan(1)) {
                    sum = s * sum + power * PlaceLanes::at(v);
                    power *= t;
                }
                return sum;
            });
    });
}

} // namespace

Point evaluate(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    // The way back from vectors rounds, and the ends are promised exactly.
    if (t == 0)
        return curve.front();
    if (t == 1)
        return curve.back();
    return curve.front() + valueOfRow(curve.size(), t, [curve](std::size_t i) { return curve[i] - curve[0]; });
}

void evaluate(std::span<const Point> curve, std::span<const double> ts, std::span<Point> points) {
    assert(!curve.empty() && points.size() == ts.size());
    if (curve.size() > kLongest) {
        std::ranges::transform(ts, points.begin(), [&](double t) { return evaluate(curve, t); });
        return;
    }
    switch (curve.size()) {
    case 1:
        std::ranges::fill(points, curve.front());
        return;
    case 2:
        return evaluateShort<2>(curve, ts, points.data());
    case 3:
        return evaluateShort<3>(curve, ts, points.data());
    case 4:
        return evaluateShort<4>(curve, ts, points.data());
    case 5:
        return evaluateShort<5>(curve, ts, points.data());
    case 6:
        return evaluateShort<6>(curve, ts, points.data());
    default:
        return evaluateLong(curve, ts, points.data());
    }
}

Vector derivative(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    if (curve.size() < 2)
        return {};
    const std::size_t degree = curve.size() - 1;
    return static_cast<double>(degree) *
           valueOfRow(degree, t, [curve](std::size_t i) { return curve[i + 1] - curve[i]; });
}

Vector secondDerivative(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    if (curve.size() < 3)
        return {};
    const std::size_t degree = curve.size() - 1;
    return static_cast<double>(degree * (degree - 1)) * valueOfRow(degree - 1, t, [curve](std::size_t i) {
               return (curve[i + 2] - curve[i + 1]) - (curve[i + 1] - curve[i]);
           });
}

std::vector<Vector> hodograph(std::span<const Point> curve) {
    assert(!curve.empty());
    const auto degree = static_cast<double>(curve.size() - 1);
    std::vector<Vector> vectors;
    vectors.reserve(curve.size() - 1);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        vectors.push_back(degree * (curve[i + 1] - curve[i]));
    return vectors;
}

std::vector<double> bernstein(int degree, double t) {
    assert(degree >= 0);
    std::vector<double> values(static_cast<std::size_t>(degree) + 1, 0.0);
    values[0] = 1;
    for (std::size_t k = 1; k < values.size(); ++k) {
        for (std::size_t i = k; i > 0; --i)
            values[i] = (1 - t) * values[i] + t * values[i - 1];
        values[0] *= 1 - t;
    }
    return values;
}

} // namespace kriva
