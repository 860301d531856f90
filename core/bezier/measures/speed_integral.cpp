#include "core/bezier/measures/speed_integral.h"

#include "core/bezier/measures/cusp_window.h"
#include "core/bezier/measures/gauss_bounds.h"

#include <cstring>

namespace kriva {

namespace {

/// Four doubles at once; compiled for two registers of two where the processor has none of four, with the same digits.
using SpeedLanes [[gnu::vector_size(32)]] = double;
constexpr std::size_t kSpeedLanes = sizeof(SpeedLanes) / sizeof(double);

/// What all parts together may be off by, relative to the whole, and how much of what is left of that one may take.
constexpr double kErrorOfAll = 8e-13;
constexpr double kShareOfOne = 0.125;

/// In a longer ellipse, in widths of the part, |c| may grow more than the error falls.
constexpr double kLongestAxis = 16;

/// What the distances of a zero from 0 and 1 add up to where cuspWindow() has one: sqrt(1 + 1/256) at most.
constexpr double kNearSum = 1.002;

/// Halvings after which a part is shorter than all that kErrorOfAll asks for.
constexpr std::size_t kDeepestPart = 64;

/// A part of [0, 1] with the sizes of both factors of c at its ends. Without initialisers: many wait on a stack.
struct Part {
    double from;
    double width;
    std::array<double, 2> start;
    std::array<double, 2> end;
};

/// The smallest rule for a part, kSizes.size() where the part is too long for all.
struct PartRule {
    std::size_t index = 0;
    double error = 0; ///< a bound of the rule's
};

[[gnu::always_inline]] inline PartRule ruleFor(const Part& part, double slope, double error) {
    // The ends are the foci of the ellipse, on which the distances from both add up to its longer axis.
    const double first = part.start[0] + part.end[0];
    const double second = part.start[1] + part.end[1];
    double axis = std::min(first, kLongestAxis * part.width);
    if (axis * slope > second)
        axis = second / slope;
    // No place in the ellipse is farther from a zero than half of both sums.
    const double most = (axis + first) * (axis * slope + second) * (part.width / 4);
    const std::size_t step = errorStep(error, most);
    const auto& needed = neededAxes(step);
    PartRule rule{0, most * errorOfStep(step)};
    while (rule.index < needed.size() && axis < needed[rule.index] * part.width)
        ++rule.index;
    return rule;
}

/// The integral by a rule of |middle + odd s + even s^2| for s between -1/2 and 1/2, or where `place` moves nodes and
/// weights to.
template <class Place>
[[gnu::always_inline]] inline double sumByRule(Vector middle, Vector odd, Vector even, const CentredRule& rule,
                                               const Place& place) {
    SpeedLanes sums{};
    for (std::size_t i = 0; i < rule.half; i += kSpeedLanes) {
        SpeedLanes s;
        SpeedLanes weights;
        std::memcpy(&s, &rule.offsets[i], sizeof s);
        std::memcpy(&weights, &rule.weights[i], sizeof weights);
        place(s, weights);
        // The even part serves both sides of the middle, and so does the odd one.
        const SpeedLanes square = s * s;
        const SpeedLanes evenX = middle.x + even.x * square;
        const SpeedLanes evenY = middle.y + even.y * square;
        const SpeedLanes leftX = evenX - odd.x * s;
        const SpeedLanes leftY = evenY - odd.y * s;
        const SpeedLanes rightX = evenX + odd.x * s;
        const SpeedLanes rightY = evenY + odd.y * s;
        SpeedLanes left = leftX * leftX + leftY * leftY;
        SpeedLanes right = rightX * rightX + rightY * rightY;
        for (std::size_t k = 0; k < kSpeedLanes; ++k) {
            left[k] = std::sqrt(left[k]);
            right[k] = std::sqrt(right[k]);
        }
        sums += weights * (left + right);
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

[[gnu::always_inline]] inline double integralOver(const Part& part, const QuadraticHodograph& c,
                                                  const CentredRule& rule) {
    const double w = part.width;
    const double m = part.from + w / 2;
    const Vector middle = (m * c.quadratic + c.linear) * m + c.constant;
    return w * sumByRule(middle, w * (2 * m * c.quadratic + c.linear), (w * w) * c.quadratic, rule,
                         [](SpeedLanes&, SpeedLanes&) {});
}

[[gnu::always_inline]] inline double integralOver(const CuspWindow& window, const QuadraticHodograph& c) {
    const double m = window.middle;
    const double length = 2 * window.top;
    const double half = window.imaginary / 2;
    const Vector middle = (m * c.quadratic + c.linear) * m + c.constant;
    return length * half *
           sumByRule(middle, 2 * m * c.quadratic + c.linear, c.quadratic, centredRule(window.rule),
                     [&](SpeedLanes& s, SpeedLanes& weights) {
                         s *= length;
                         substitute(window.depth, s, weights);
                         s *= half;
                     });
}

inline double absoluteOf(Vector v) {
    return std::sqrt(dot(v, v));
}

/// A lower bound of the integral: the chords of both halves of the curve, or what the largest Bernstein coefficient
/// tells. That one is at most three times the largest speed, and the speed at most nine times its mean: the square of
/// degree + 1, by the sum of the squares of the Legendre polynomials that it is made of.
inline double lowerBoundOf(const QuadraticHodograph& c) {
    const Vector left = c.constant / 2 + c.linear / 8 + c.quadratic / 24;
    const Vector right = c.constant / 2 + 3 * c.linear / 8 + 7 * c.quadratic / 24;
    const Vector inner = c.constant + c.linear / 2;
    const Vector end = c.constant + c.linear + c.quadratic;
    const double largest = std::max({std::abs(c.constant.x), std::abs(c.constant.y), std::abs(inner.x),
                                     std::abs(inner.y), std::abs(end.x), std::abs(end.y)});
    return std::max(absoluteOf(left) + absoluteOf(right), largest / 27);
}

[[gnu::always_inline]] inline double integralBy(const QuadraticHodograph& c) {
    const HodographFactors factors(c);
    if (factors.isMonomial())
        return absoluteOf(c.constant) + absoluteOf(c.quadratic) / 3;
    double error = kErrorOfAll * lowerBoundOf(c);
    std::array<Part, kDeepestPart> waiting;
    std::size_t count = 0;
    Part part{0, 1, factors.sizesAt(0), factors.sizesAt(1)};
    double sum = 0;
    const auto mayBeNear = [](double start, double end, double width) { return start + end < kNearSum * width; };
    const bool isNear =
        mayBeNear(part.start[0], part.end[0], 1) || mayBeNear(part.start[1], part.end[1], factors.slope());
    if (const auto window = isNear ? cuspWindow(factors, error * kShareOfOne) : std::nullopt) {
        error -= window->error;
        sum = integralOver(*window, c);
        const double left = window->middle - window->halfWidth;
        const double right = window->middle + window->halfWidth;
        waiting[count++] = {right, 1 - right, factors.sizesAt(right), part.end};
        part = {0, left, part.start, factors.sizesAt(left)};
    }
    while (true) {
        const PartRule rule = ruleFor(part, factors.slope(), error * kShareOfOne);
        if (rule.index == CentredRule::kSizes.size() && count < waiting.size()) {
            part.width /= 2;
            const double middle = part.from + part.width;
            const std::array<double, 2> sizes = factors.sizesAt(middle);
            waiting[count++] = {middle, part.width, sizes, part.end};
            part.end = sizes;
            continue;
        }
        error -= rule.error;
        sum += integralOver(part, c, centredRule(std::min(rule.index, CentredRule::kSizes.size() - 1)));
        if (count == 0)
            return sum;
        part = waiting[--count];
    }
}

#ifdef __x86_64__
[[gnu::target("avx2")]] double integralByAvx2(const QuadraticHodograph& c) {
    return integralBy(c);
}
#endif

} // namespace

double integralOfSpeed(const QuadraticHodograph& c) {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2"))
        return integralByAvx2(c);
#endif
    return integralBy(c);
}

} // namespace kriva
