#include "core/figure/ticks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kriva {
namespace {

constexpr std::size_t kMostMultiples = 10'000;

} // namespace

double roundStep(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1, 2, 5})
        if (factor * power >= least)
            return factor * power;
    return 10 * power;
}

int decimalsOf(double step) {
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 17);
}

std::vector<double> multiples(double step, double low, double high) {
    const double first = std::ceil(low / step);
    std::vector<double> found;
    // Counted from the first one: far from the origin index + 1 may be index, and nothing must go round for ever.
    for (std::size_t i = 0; i < kMostMultiples; ++i) {
        const double multiple = (first + static_cast<double>(i)) * step;
        if (multiple > high)
            break;
        found.push_back(multiple);
    }
    return found;
}

} // namespace kriva
