#include "core/polynomial/graph.h"

#include "core/polynomial/absolute_integral.h"
#include "core/polynomial/bases.h"

#include <algorithm>

namespace kriva {
namespace {

using Coefficients = std::vector<BigFloat>;

/// A part of the parameter interval: [index, index + 1] / 2^level.
struct Part {
    Coefficients coefficients;
    int level = 0;
    double index = 0;
};

/// The largest difference between Bernstein coefficients: how high the part's hull is.
double heightOfHull(const Coefficients& coefficients) {
    double low = 0;
    double high = 0;
    for (const BigFloat& c : coefficients) {
        const double above = (c - coefficients.front()).toDouble();
        low = std::min(low, above);
        high = std::max(high, above);
    }
    return high - low;
}

std::pair<Part, Part> halves(const Part& part) {
    Part right{part.coefficients, part.level + 1, 2 * part.index + 1};
    Part left{{}, part.level + 1, 2 * part.index};
    Coefficients& c = right.coefficients;
    for (std::size_t last = c.size(); last-- > 0;) {
        left.coefficients.push_back(c[0]);
        for (std::size_t i = 0; i < last; ++i)
            c[i] = (c[i] + c[i + 1]).half();
    }
    return {std::move(left), std::move(right)};
}

/// Cuts a part as long as its hull is much higher than that of its halves: there the control points are much larger
/// than the curve, and their roundings visible on it. A hull that fits shrinks by no more than this factor.
void cutWhereIllConditioned(Part part, std::vector<Part>& parts) {
    constexpr int kSafeDegree = 9; // control points at most 347 times larger than the curve, that of T_9
    constexpr double kShrinking = 4;
    constexpr int kMostLevels = 24;
    if (part.coefficients.size() <= kSafeDegree + 1 || part.level == kMostLevels) {
        parts.push_back(std::move(part));
        return;
    }
    auto [left, right] = halves(part);
    // The halves share the middle point, from which both heights are counted at most twice.
    if (heightOfHull(part.coefficients) <=
        kShrinking * (heightOfHull(left.coefficients) + heightOfHull(right.coefficients))) {
        parts.push_back(std::move(part));
        return;
    }
    part.coefficients.clear();
    cutWhereIllConditioned(std::move(left), parts);
    cutWhereIllConditioned(std::move(right), parts);
}

/// The Bézier curve of a part of the graph from `from` to `to`.
Points controlPoints(const Part& part, double from, double to) {
    const DoubleDouble span = exactSum(to, -from);
    const auto n = static_cast<double>(part.coefficients.size() - 1);
    Points points;
    for (const BigFloat& c : part.coefficients) {
        const double position = part.index * n + static_cast<double>(points.size());
        points.push_back({(span * position / std::ldexp(n, part.level) + from).high, c.toDouble()});
    }
    return points;
}

/// The shape of a part of the graph from `from` to `to`.
Points shapeOf(const Part& part, double from, double to) {
    const auto n = static_cast<double>(part.coefficients.size() - 1);
    const DoubleDouble step = exactSum(to, -from) / std::ldexp(n, part.level);
    std::vector<WideVector> vectors;
    for (const BigFloat& c : part.coefficients)
        vectors.push_back(
            {step * static_cast<double>(vectors.size()), (c - part.coefficients.front()).toDoubleDouble()});
    return shapeOf(vectors);
}

/// The Bernstein coefficients of |to - from| y'' over a part; its integral by t is that of y'' by x.
BernsteinPiece secondDerivative(const Part& part, double width) {
    const std::size_t n = part.coefficients.size() - 1;
    BernsteinPiece second{{}, std::ldexp(1, -part.level)};
    const double factor = static_cast<double>(n * (n - 1)) * std::ldexp(1, 2 * part.level) / width;
    for (std::size_t i = 0; i + 2 <= n; ++i) {
        const BigFloat difference =
            part.coefficients[i + 2] - part.coefficients[i + 1] - (part.coefficients[i + 1] - part.coefficients[i]);
        second.coefficients.push_back(difference.toDouble() * factor);
    }
    return second;
}

/// The slope of the graph between two neighbouring coefficients of its whole; `perStep` is one over the way between
/// them.
DoubleDouble slope(const BigFloat& left, const BigFloat& right, const BigFloat& perStep) {
    return ((right - left) * perStep).toDoubleDouble();
}

} // namespace

Graph graphOf(const Polynomial& polynomial, double from, double to) {
    Part whole{bernsteinCoefficients(polynomial, from, to)};
    const Coefficients& b = whole.coefficients;
    // Divided by once: there is no dearer operation.
    const BigFloat perStep = polynomial.number(polynomial.degree()) / (polynomial.number(to) - polynomial.number(from));
    Graph graph;
    graph.curve = controlPoints(whole, from, to);
    graph.startValue = b.front().toDoubleDouble();
    graph.endValue = b.back().toDoubleDouble();
    graph.startSlope = slope(b[0], b[1], perStep);
    graph.endSlope = slope(b[b.size() - 2], b.back(), perStep);
    std::vector<Part> parts;
    cutWhereIllConditioned(std::move(whole), parts);
    std::vector<BernsteinPiece> second;
    for (const Part& part : parts) {
        graph.parts.push_back(controlPoints(part, from, to));
        graph.shapes.push_back(shapeOf(part, from, to));
        if (part.coefficients.size() > 2)
            second.push_back(secondDerivative(part, std::abs(to - from)));
    }
    graph.slopeVariation = absoluteIntegral(std::move(second));
    return graph;
}

} // namespace kriva
