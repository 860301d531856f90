#include "core/bezier/measures/gauss_bounds.h"

#include "core/polynomial/bernstein_polynomial.h"

#include <cassert>

namespace kriva {

namespace {

constexpr double longerAxisNeeded(int points, double error) {
    double low = 1;
    double high = 1e4;
    for (int i = 0; i < 60; ++i) {
        const double rho = low / 2 + high / 2;
        const double decay = power(1 / rho, 2 * static_cast<std::size_t>(points));
        const bool enough = decay <= error * 15 / 32 * (1 - 1 / (rho * rho));
        (enough ? high : low) = rho;
    }
    return high / 2 + 1 / (2 * high);
}

constexpr auto kNeededAxes = [] {
    std::array<std::array<double, CentredRule::kSizes.size()>, kErrorSteps> axes{};
    for (std::size_t step = 1; step < kErrorSteps; ++step)
        for (std::size_t rule = 0; rule < axes[step].size(); ++rule)
            axes[step][rule] = longerAxisNeeded(CentredRule::kSizes[rule], errorOfStep(step));
    return axes;
}();

} // namespace

const std::array<double, CentredRule::kSizes.size()>& neededAxes(std::size_t step) {
    assert(step < kNeededAxes.size());
    return kNeededAxes[step];
}

} // namespace kriva
