#include "core/polynomial/long_rows.h"

#include "core/numbers/lanes.h"

#include <cassert>
#include <cstring>

namespace kriva {

namespace {

static_assert(sizeof(Vector) == 2 * sizeof(double));

/// One level of the scheme on `size` numbers, of which each `stride` are a coefficient.
template <std::size_t stride>
[[gnu::always_inline]] inline void interpolate(double* row, std::size_t size, double t) {
    const double s = 1 - t;
    std::size_t i = 0;
    for (; i + kLanes + stride <= size; i += kLanes) {
        Lanes here;
        Lanes next;
        load(row + i, here);
        load(row + i + stride, next);
        store(s * here + t * next, row + i);
    }
    for (; i + stride < size; ++i)
        row[i] = s * row[i] + t * row[i + stride];
}

template <std::size_t stride>
[[gnu::always_inline]] inline void split(double* row, double* left, std::size_t size, double t) {
    for (std::size_t rest = size; rest > 0; rest -= stride) {
        std::memcpy(left + (size - rest), row, stride * sizeof(double));
        interpolate<stride>(row, rest, t);
    }
}

/// Horner's scheme at kLanes ratios.
struct Sums {
    Lanes x;
    Lanes y;

    [[gnu::always_inline]] explicit Sums(Vector first)
        : x{first.x, first.x, first.x, first.x}
        , y{first.y, first.y, first.y, first.y} {}
    [[gnu::always_inline]] void add(const Lanes& ratios, Vector next) {
        x = ratios * x + next.x;
        y = ratios * y + next.y;
    }
    [[gnu::always_inline]] void write(Vector* sums) const {
        for (std::size_t k = 0; k < kLanes; ++k)
            sums[k] = {x[k], y[k]};
    }
};

[[gnu::always_inline]] inline void horner(std::span<const Vector> row, const double* ratios, Vector* near,
                                          Vector* far) {
    static_assert(kTogetherInLongRow == 2 * kLanes);
    Lanes low;
    Lanes high;
    load(ratios, low);
    load(ratios + kLanes, high);
    Sums nearLow(row.back());
    Sums nearHigh(row.back());
    Sums farLow(row.front());
    Sums farHigh(row.front());
    for (std::size_t i = 1; i < row.size(); ++i) {
        const Vector before = row[row.size() - 1 - i];
        nearLow.add(low, before);
        nearHigh.add(high, before);
        farLow.add(low, row[i]);
        farHigh.add(high, row[i]);
    }
    nearLow.write(near);
    nearHigh.write(near + kLanes);
    farLow.write(far);
    farHigh.write(far + kLanes);
}

template <std::size_t stride>
void splitRow(double* row, double* left, std::size_t size, double t) {
    workByLanes([=]() __attribute__((always_inline)) { split<stride>(row, left, size, t); });
}

} // namespace

void splitLongRow(std::span<double> row, std::span<double> left, double t) {
    assert(left.size() == row.size());
    splitRow<1>(row.data(), left.data(), row.size(), t);
}

void splitLongRow(std::span<Vector> row, std::span<Vector> left, double t) {
    assert(left.size() == row.size());
    splitRow<2>(&row.data()->x, &left.data()->x, 2 * row.size(), t);
}

void evaluateLongRow(std::span<const Vector> row, const ManyRatios& ratios, ManyVectors& near, ManyVectors& far) {
    workByLanes([&]() __attribute__((always_inline)) { horner(row, ratios.data(), near.data(), far.data()); });
}

} // namespace kriva
