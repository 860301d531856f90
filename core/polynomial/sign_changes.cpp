#include "core/polynomial/sign_changes.h"

#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <limits>

namespace kriva {

namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;

/// Where the change is, as a share of its part: regula falsi by the Illinois rule, with every third step a halving, so
/// that the bracket shrinks even where the secant creeps.
template <class T>
double onlyChange(const IsolatedChange<T>& change) {
    RowBuffer<T> scaled(change.coefficients.size());
    std::ranges::copy(change.coefficients, scaled.row().begin());
    scaleByBinomials(scaled.row());
    double low = 0;
    double high = 1;
    // An end may be zero itself; then the first secant step fails and the halving takes over.
    double atLow = std::min(0.0, change.sign * static_cast<double>(change.coefficients.front()));
    double atHigh = std::max(0.0, change.sign * static_cast<double>(change.coefficients.back()));
    int kept = 0;
    for (int step = 0; high - low > kRounding; ++step) {
        double t = low - atLow * (high - low) / (atHigh - atLow);
        if (step % 3 == 2 || !(t > low && t < high))
            t = low / 2 + high / 2;
        if (t <= low || t >= high)
            break;
        const auto [near, far] = mirroredValues(std::span<const T>(scaled.row()), std::min(t, 1 - t));
        const double value = change.sign * static_cast<double>(t <= 0.5 ? near : far);
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

template <class T>
struct Changes {
    std::vector<double> found;
    bool areCertain = true;
};

template <class T>
Changes<T> changesOf(std::span<const T> coefficients, double noise) {
    Changes<T> changes;
    const SignWalk walk(coefficients, noise, [&](const IsolatedChange<T>& change) {
        changes.found.push_back(change.coefficients.empty()
                                    ? change.from / 2 + change.to / 2
                                    : change.from + (change.to - change.from) * onlyChange(change));
    });
    changes.areCertain = walk.isCertain();
    return changes;
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
    return changesOf(coefficients, 0).found;
}

std::optional<std::vector<double>> certainSignChanges(std::span<const double> coefficients, double noise) {
    Changes<double> changes = changesOf(coefficients, noise);
    return changes.areCertain ? std::optional(std::move(changes.found)) : std::nullopt;
}

std::vector<double> signChanges(std::span<const DoubleDouble> coefficients, double noise) {
    return changesOf(coefficients, noise).found;
}

} // namespace kriva
