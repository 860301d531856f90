#pragma once

#include "core/numbers/double_double.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kriva {

/// The parameters in the open interval (0, 1), ascending, where the polynomial with these Bernstein coefficients
/// changes its sign. Roots without a change are left out. Where its values drown in noise, the change lies in the
/// middle of that stretch, and several count by their parity. The zero polynomial has none.
///
/// Isolated by halving and Descartes' rule of signs, then refined by bracketing: O(degree^2) per root and halving.
/// Source: Lane, Riesenfeld, Bounds on a polynomial, BIT 21 (1981).
///
/// The noise is the rounding error of the work in doubles.
[[nodiscard]] std::vector<double> signChanges(std::span<const double> coefficients);

/// The same where every sign that counts stands out of the noise that the coefficients carry; else nothing.
[[nodiscard]] std::optional<std::vector<double>> certainSignChanges(std::span<const double> coefficients, double noise);

/// The same in double-double arithmetic, with the noise that the coefficients already carry.
[[nodiscard]] std::vector<double> signChanges(std::span<const DoubleDouble> coefficients, double noise);

/// A part of [0, 1] in which a polynomial changes its sign once.
template <class T>
struct IsolatedChange {
    double from = 0;
    double to = 0;
    int sign = 0;                    ///< behind the change
    std::span<const T> coefficients; ///< on that part; none where the polynomial drowns in noise there
};

/// What Descartes' rule sees in a row of coefficients: how often the sign changes, and the signs at both ends, 0 where
/// all coefficients drown in noise.
struct RowSigns {
    int first = 0;
    int last = 0;
    int variations = 0;
    bool isCertain = true; ///< no coefficient drowns
};

template <class T>
[[nodiscard]] RowSigns signsOf(std::span<const T> coefficients, double noise) {
    RowSigns signs;
    for (const T& c : coefficients) {
        const auto value = static_cast<double>(c);
        if (std::abs(value) <= noise) {
            signs.isCertain = false;
            continue;
        }
        const int sign = value > 0 ? 1 : -1;
        if (signs.last == -sign)
            ++signs.variations;
        if (signs.first == 0)
            signs.first = sign;
        signs.last = sign;
    }
    return signs;
}

/// Halves [0, 1] until each part has one change of sign at most, and visits those that have one, from left to right:
/// visit(IsolatedChange). What signChanges() does before it refines.
template <class T, class Visit>
class SignWalk {
  public:
    /// The noise of the coefficients grows by that of the splits: three roundings at each level, of which only the
    /// first splits see large coefficients.
    SignWalk(std::span<const T> coefficients, double noise, Visit visit)
        : noise_(noise)
        , visit_(std::move(visit)) {
        double largest = 0;
        for (const T& c : coefficients)
            largest = std::max(largest, std::abs(static_cast<double>(c)));
        noise_ += 3 * static_cast<double>(coefficients.size()) * kRounding * largest;
        RowBuffer<T> row(coefficients.size());
        std::ranges::copy(coefficients, row.row().begin());
        walk(row.row(), 0, 1, 0);
    }

    /// Whether every sign that counts stands out of the noise.
    [[nodiscard]] bool isCertain() const { return isCertain_; }

  private:
    /// What one operation loses, relative to the operands.
    static constexpr double kRounding =
        std::is_same_v<T, double> ? std::numeric_limits<double>::epsilon() / 2 : 0x1p-102;
    /// Halvings of [0, 1] after which neighbouring doubles are reached.
    static constexpr int kDeepest = 52;

    void walk(std::span<T> row, double from, double to, int depth) {
        const RowSigns signs = signsOf(std::span<const T>(row), noise_);
        if (signs.first == 0 || (signs.variations > 1 && depth == kDeepest)) {
            isCertain_ = false;
            return;
        }
        if (signs.variations > 1) {
            RowBuffer<T> left(row.size());
            splitInPlace(row, left.row(), 0.5);
            const double middle = from / 2 + to / 2;
            walk(left.row(), from, middle, depth + 1);
            walk(row, middle, to, depth + 1);
            return;
        }
        isCertain_ = isCertain_ && signs.isCertain;
        if (sign_ == -signs.first)
            visit_(IsolatedChange<T>{until_, from, signs.first, {}});
        if (signs.variations == 1)
            visit_(IsolatedChange<T>{from, to, signs.last, row});
        sign_ = signs.last;
        until_ = to;
    }

    double noise_;
    Visit visit_;
    int sign_ = 0; ///< of the polynomial up to `until_`, 0 while unknown
    double until_ = 0;
    bool isCertain_ = true;
};

} // namespace kriva
