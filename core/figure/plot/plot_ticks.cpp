#include "core/figure/plot/plot_ticks.h"

#include "core/figure/labels.h"
#include "core/figure/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kriva {
namespace {

/// "10⁻⁷"
std::string powerOfTen(int exponent) {
    static constexpr std::array<std::string_view, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = "10";
    if (exponent < 0)
        text += "⁻";
    for (const char digit : decimal(std::abs(exponent)))
        text += kDigits[static_cast<std::size_t>(digit - '0')];
    return text;
}

/// A number as a person reads it, however large or small.
void setNumber(Label& label, double value, double step) {
    constexpr double kPlainLow = 1e-4;
    constexpr double kPlainHigh = 1e6;
    if (value == 0 || (step >= kPlainLow && std::abs(value) < kPlainHigh)) {
        label.number = LabelNumber{value, decimalsOf(step)};
        return;
    }
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    const double mantissa = value / std::pow(10, exponent);
    label.number = LabelNumber{mantissa, decimalsOf(std::min(1.0, step / std::pow(10, exponent)))};
    label.text = "·" + powerOfTen(exponent);
}

std::vector<PlotTick> linearTicks(const PlotAxis& axis, double length, double spacing) {
    std::vector<PlotTick> ticks;
    const double step = roundStep(spacing * (axis.high - axis.low) / length);
    for (const double at : multiples(step, axis.low, axis.high)) {
        PlotTick& tick = ticks.emplace_back(at, Label{});
        setNumber(tick.label, at, step);
    }
    return ticks;
}

/// Powers of ten, and 2 and 5 times these where there is room; in a part of a decade, ticks as on a linear axis.
std::vector<PlotTick> logarithmicTicks(const PlotAxis& axis, double length, double spacing) {
    const double low = std::log10(axis.low);
    const double high = std::log10(axis.high);
    if (high - low < 1)
        return linearTicks(axis, length, spacing);
    std::vector<PlotTick> ticks;
    const double step = std::max(1.0, roundStep(spacing * (high - low) / length));
    const bool hasRoom = length / (high - low) > 4 * spacing;
    for (const double exponent : multiples(step, std::floor(low), high + 1e-9))
        for (const double factor : {1.0, 2.0, 5.0}) {
            constexpr double kPlain = 3.5;
            const double at = factor * std::pow(10, exponent);
            const bool isSeen = at >= axis.low * (1 - 1e-9) && at <= axis.high * (1 + 1e-9);
            if (!isSeen || (factor > 1 && !hasRoom))
                continue;
            PlotTick& tick = ticks.emplace_back(at, Label{});
            if (std::abs(exponent) < kPlain)
                tick.label.number = LabelNumber{at, std::max(0, static_cast<int>(-exponent))};
            else if (factor == 1)
                tick.label.text = powerOfTen(static_cast<int>(exponent));
        }
    return ticks;
}

} // namespace

std::vector<PlotTick> ticksOf(const PlotAxis& axis, double length, double spacing) {
    constexpr double kLeastPart = 0.4;
    std::vector<PlotTick> ticks;
    for (double part = 1; ticks.size() < 2 && part > kLeastPart; part *= 0.8)
        ticks = axis.isLogarithmic ? logarithmicTicks(axis, length, part * spacing)
                                   : linearTicks(axis, length, part * spacing);
    return ticks;
}

} // namespace kriva
