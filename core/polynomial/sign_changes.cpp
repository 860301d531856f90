#include "core/polynomial/sign_changes.h"

#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace kriva {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;

/// What one operation loses, relative to the operands.
template <class T>
constexpr double kRoundingOf = std::is_same_v<T, double> ? kRounding : 0x1p-102;

/// Halvings of [0, 1] after which neighbouring doubles are reached.
constexpr int kDeepest = 52;

/// What Descartes' rule sees in a row of coefficients: how often the sign changes, and the signs at both ends, 0 where
/// all coefficients drown in noise.
struct Signs {
    int first = 0;
    int last = 0;
    int variations = 0;
    bool certain = true; ///< no coefficient drowns
};

template <class T>
Signs signsOf(std::span<const T> coefficients, double noise) {
    Signs signs;
    for (const T& c : coefficients) {
        const auto value = static_cast<double>(c);
        if (std::abs(value) <= noise) {
            signs.certain = false;
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

/// The only sign change in (0, 1), from -rising to +rising: regula falsi by the Illinois rule, with every third step a
/// halving, so that the bracket shrinks even where the secant creeps.
template <class T>
double onlyChange(std::span<const T> coefficients, int rising) {
    RowBuffer<T> scaled(coefficients.size());
    std::ranges::copy(coefficients, scaled.row().begin());
    scaleByBinomials(scaled.row());
    double low = 0;
    double high = 1;
    // An end may be zero itself; then the first secant step fails and the halving takes over.
    double atLow = std::min(0.0, rising * static_cast<double>(coefficients.front()));
    double atHigh = std::max(0.0, rising * static_cast<double>(coefficients.back()));
    int kept = 0;
    for (int step = 0; high - low > kRounding; ++step) {
        double t = low - atLow * (high - low) / (atHigh - atLow);
        if (step % 3 == 2 || !(t > low && t < high))
            t = low / 2 + high / 2;
        if (t <= low || t >= high)
            break;
        const auto [near, far] = mirroredValues(std::span<const T>(scaled.row()), std::min(t, 1 - t));
        const double value = rising * static_cast<double>(t <= 0.5 ? near : far);
        if (value == 0)
            return t;
        const int side = value > 0 ? 1 : -1;
        (side > 0 ? high : low) = t;
        (side > 0 ? atHigh : atLow) = value;
        if (kept == side)
            (side > 0 ? atLow : atHigh) /= 2;
        kept = side;
    }
    return low / 2 + high / 2;
}

/// Walks over the pieces of [0, 1] from left to right and notes where the sign changes.
template <class T>
struct Walk {
    double noise = 0;
    std::vector<double> found;
    int sign = 0; ///< of the polynomial up to `until`, 0 while unknown
    double until = 0;
    bool certain = true;

    void visit(std::span<T> row, double from, double to, int depth) {
        const Signs signs = signsOf(std::span<const T>(row), noise);
        if (signs.first == 0 || (signs.variations > 1 && depth == kDeepest)) {
            certain = false;
            return;
        }
        if (signs.variations > 1) {
            std::vector<T> left(row.size());
            splitInPlace(row, std::span(left), 0.5);
            const double middle = from / 2 + to / 2;
            visit(left, from, middle, depth + 1);
            visit(row, middle, to, depth + 1);
            return;
        }
        certain = certain && signs.certain;
        if (sign == -signs.first)
            found.push_back(until / 2 + from / 2);
        if (signs.variations == 1)
            found.push_back(from + (to - from) * onlyChange(std::span<const T>(row), signs.last));
        sign = signs.last;
        until = to;
    }
};

/// The noise of the coefficients grows by that of the splits: three roundings at each level, of which only the first
/// splits see large coefficients.
template <class T>
Walk<T> walked(std::span<const T> coefficients, double noise) {
    std::vector<T> row(coefficients.begin(), coefficients.end());
    Walk<T> walk;
    walk.noise = noise + 3 * static_cast<double>(row.size()) * kRoundingOf<T> * largestCoefficient(coefficients);
    walk.visit(row, 0, 1, 0);
    return walk;
}

/// The roots of c_0 (1 - t)^2 + 2 c_1 t (1 - t) + c_2 t^2 where it changes sign, by the formula that never subtracts
/// nearly equal numbers.
std::vector<double> quadraticChanges(double c0, double c1, double c2) {
    const double discriminant = c1 * c1 - c0 * c2;
    if (discriminant <= 0)
        return {};
    const double q = (c0 - c1) + std::copysign(std::sqrt(discriminant), c0 - c1);
    std::vector<double> found;
    for (const double t : {q / ((c0 - c1) + (c2 - c1)), c0 / q})
        if (0 < t && t < 1)
            found.push_back(t);
    std::ranges::sort(found);
    return found;
}

} // namespace

std::vector<double> signChanges(std::span<const double> coefficients) {
    if (coefficients.size() == 2)
        return quadraticChanges(coefficients[0], (coefficients[0] + coefficients[1]) / 2, coefficients[1]);
    if (coefficients.size() == 3)
        return quadraticChanges(coefficients[0], coefficients[1], coefficients[2]);
    return walked(coefficients, 0).found;
}

std::optional<std::vector<double>> certainSignChanges(std::span<const double> coefficients, double noise) {
    Walk<double> walk = walked(coefficients, noise);
    return walk.certain ? std::optional(std::move(walk.found)) : std::nullopt;
}

std::vector<double> signChanges(std::span<const DoubleDouble> coefficients, double noise) {
    return walked(coefficients, noise).found;
}

} // namespace kriva
