#include "core/bezier/bernstein_roots.h"

#include "core/bezier/casteljau.h"

#include <algorithm>
#include <limits>

namespace kriva {

namespace {

/// Halvings of [0, 1] after which neighbouring doubles are reached.
constexpr int kDeepest = 52;

int sign(double value, double noise) {
    return value > noise ? 1 : value < -noise ? -1 : 0;
}

/// What Descartes' rule sees in a row of coefficients: how often the sign changes, and the signs at both ends
/// (0 where all coefficients drown in noise).
struct Signs {
    int first = 0;
    int last = 0;
    int variations = 0;
};

Signs signsOf(std::span<const double> coefficients, double noise) {
    Signs signs;
    for (const double c : coefficients) {
        const int s = sign(c, noise);
        if (s == 0)
            continue;
        if (signs.last != 0 && s != signs.last)
            ++signs.variations;
        if (signs.first == 0)
            signs.first = s;
        signs.last = s;
    }
    return signs;
}

/// The only root in (0, 1) of a polynomial whose value rises or falls through it: bisection made faster by the
/// Illinois rule.
double onlyRoot(std::span<const double> coefficients) {
    RowBuffer<double> buffer(coefficients.size());
    const auto value = [&](double t) {
        std::ranges::copy(coefficients, buffer.row().begin());
        return valueInPlace(buffer.row(), t);
    };
    double low = 0;
    double high = 1;
    double atLow = coefficients.front();
    double atHigh = coefficients.back();
    // The coefficients at the ends may be zero, the sign next to them is the one of their neighbours.
    for (const double c : coefficients)
        if (atLow == 0)
            atLow = c;
    for (auto c = coefficients.rbegin(); c != coefficients.rend() && atHigh == 0; ++c)
        atHigh = *c;
    int kept = 0;
    for (int i = 0; i < 200 && high - low > std::numeric_limits<double>::epsilon() / 2 * high; ++i) {
        double t = low - atLow * (high - low) / (atHigh - atLow);
        // Every third step halves, so the bracket shrinks even where the secant creeps.
        if (!(t > low && t < high) || i % 3 == 2)
            t = low / 2 + high / 2;
        if (t <= low || t >= high)
            break;
        const double here = value(t);
        if (here == 0)
            return t;
        if ((here > 0) == (atHigh > 0)) {
            high = t;
            atHigh = here;
            atLow *= kept > 0 ? 0.5 : 1;
            kept = 1;
        } else {
            low = t;
            atLow = here;
            atHigh *= kept < 0 ? 0.5 : 1;
            kept = -1;
        }
    }
    return low / 2 + high / 2;
}

/// Walks over the pieces of [0, 1] from left to right and notes where the sign turns.
struct Walk {
    double noise = 0;
    std::vector<double> found;
    int sign = 0; // of the polynomial just before `until`, 0 while unknown
    double until = 0;

    void visit(std::span<double> row, double from, double to, int depth);
    void meet(int next, double at) {
        if (sign != 0 && next != sign)
            found.push_back(until / 2 + at / 2);
    }
};

void Walk::visit(std::span<double> row, double from, double to, int depth) {
    const Signs signs = signsOf(row, noise);
    if (signs.first == 0)
        return;
    if (signs.variations >= 2) {
        if (depth == kDeepest)
            return;
        std::vector<double> left(row.size());
        splitInPlace(row, std::span(left), 0.5);
        const double middle = from / 2 + to / 2;
        visit(left, from, middle, depth + 1);
        visit(row, middle, to, depth + 1);
        return;
    }
    meet(signs.first, from);
    if (signs.variations == 1)
        found.push_back(from + (to - from) * onlyRoot(row));
    sign = signs.last;
    until = to;
}

} // namespace

std::vector<double> signChanges(std::span<const double> coefficients) {
    double largest = 0;
    for (const double c : coefficients)
        largest = std::max(largest, std::abs(c));
    Walk walk;
    // Each level of a split rounds three times, and only the first splits see large coefficients.
    walk.noise = 3 * static_cast<double>(coefficients.size()) * std::numeric_limits<double>::epsilon() / 2 * largest;
    std::vector<double> row(coefficients.begin(), coefficients.end());
    walk.visit(row, 0, 1, 0);
    return walk.found;
}

} // namespace kriva
