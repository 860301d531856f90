#pragma once

#include "core/polynomial/long_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>

/// De Casteljau's scheme on plain coefficients (numbers or vectors): what evaluation, splitting and root isolation
/// share.
namespace kriva {

/// One level of the scheme in place: row[i] becomes (1 - t) row[i] + t row[i + 1]; the last entry stays.
template <class T>
constexpr void interpolateRow(std::span<T> row, double t) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
        row[i] = (1 - t) * row[i] + t * row[i + 1];
}

/// The value at t of the polynomial with these Bernstein coefficients, which are used up. At least one is needed.
template <class T>
[[nodiscard]] constexpr T valueInPlace(std::span<T> row, double t) {
    for (std::size_t count = row.size(); count > 1; --count)
        interpolateRow(row.first(count), t);
    return row.front();
}

/// Writes the left part of a split at t to `left` (of the same size) and leaves the right part in `row`.
template <class T>
constexpr void splitInPlace(std::span<T> row, std::span<T> left, double t) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Vector>)
        if (row.size() >= kLongRow)
            return splitLongRow(row, left, t);
    for (std::size_t count = row.size(); count > 0; --count) {
        left[row.size() - count] = row.front();
        interpolateRow(row.first(count), t);
    }
}

/// Room for one row that asks the heap only above degree 11: evaluation runs in the innermost loops.
template <class T>
class RowBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    explicit RowBuffer(std::size_t size)
        : heap_(size > kInline ? size : 0)
        , row_(size > kInline ? heap_.data() : reinterpret_cast<T*>(inline_.data()), size) {
        std::uninitialized_value_construct_n(row_.data(), size > kInline ? 0 : std::max<std::size_t>(size, 1));
    }
    RowBuffer(const RowBuffer&) = delete;
    RowBuffer& operator=(const RowBuffer&) = delete;

    [[nodiscard]] std::span<T> row() { return row_; }

  private:
    static constexpr std::size_t kInline = 12;
    // Bytes, since clearing as many numbers as there is room for takes as long as the work on a few.
    alignas(T) std::array<std::byte, kInline * sizeof(T)> inline_;
    std::vector<T> heap_;
    std::span<T> row_;
};

/// Writes the control points as vectors from the first one. The schemes run on these, so that a curve far from the
/// origin loses nothing to the size of its coordinates.
constexpr void writeFromStart(std::span<const Point> curve, std::span<Vector> row) {
    for (std::size_t i = 0; i < curve.size(); ++i)
        row[i] = curve[i] - curve.front();
}

} // namespace kriva
