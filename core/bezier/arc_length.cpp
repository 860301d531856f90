#include "core/bezier/arc_length.h"

#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/gauss_legendre.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace kriva {

namespace {

/// Share of the error that a piece may have of its own length, and every piece of the whole length. There are less
/// than 200 pieces at a cusp, so both together stay below 1e-12.
constexpr double kOwnError = 2e-13;
constexpr double kSharedError = 1e-15;

/// Halvings after which a piece is too short to matter: 2^-60 of the largest speed times the parameter.
constexpr int kDeepest = 60;

/// A part of the curve on which one Gauss rule gives the length.
struct Piece {
    std::vector<Vector> speed; // control vectors of the derivative by the local parameter
    double from = 0;
    double to = 1;
    std::size_t rule = 0;
};

double power(double base, std::size_t exponent) {
    double result = 1;
    for (; exponent > 0; exponent /= 2, base *= base)
        result *= exponent % 2 == 1 ? base : 1;
    return result;
}

double size(Vector v) {
    return std::sqrt(dot(v, v));
}

/// How many points a rule needs, as an index of gaussSizes(), for an error of at most `allowed` on a piece with these
/// control vectors; nothing if it is better to halve the piece.
///
/// With m any vector and D = max |c_i - m|, the derivative c(t) as a complex polynomial of degree d satisfies
/// |c(t) - m| <= (|t| + |1 - t|)^d D for complex t, and so does its conjugate polynomial. Where this is below |m|,
/// the speed sqrt(c conj(c)) is analytic and within 3 |m| of |m|. That is inside the ellipse |t| + |1 - t| = s with
/// s^d = |m| / D, whose Bernstein parameter is rho = s + sqrt(s^2 - 1).
std::optional<std::size_t> sufficientRule(std::span<const Vector> speed, double shared) {
    const std::size_t degree = speed.size() - 1;
    Vector low = speed.front();
    Vector high = speed.front();
    for (const Vector c : speed) {
        low = {std::min(low.x, c.x), std::min(low.y, c.y)};
        high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
    const Vector m = low / 2 + high / 2;
    double deviation = 0;
    for (const Vector c : speed)
        deviation = std::max(deviation, dot(c - m, c - m));
    deviation = std::sqrt(deviation);
    const double mean = size(m);
    const double allowed = kOwnError * (mean - deviation) + shared;
    // Even the control polygon is shorter than the allowed error.
    if (mean + deviation <= allowed || deviation == 0)
        return 0;
    if (deviation >= mean)
        return std::nullopt;
    const double s = std::pow(mean / deviation, 1 / static_cast<double>(degree));
    const double rho = s + std::sqrt(s * s - 1);
    const double points = 1 + std::log(6.4 * mean / (allowed * (1 - 1 / (rho * rho)))) / (2 * std::log(rho));
    // Halving costs more than further points, the more so the higher the degree.
    const double most = std::max(16.0, 9 * std::sqrt(static_cast<double>(degree)));
    if (points > most)
        return std::nullopt;
    const auto enough = std::ranges::lower_bound(gaussSizes(), points);
    if (enough == gaussSizes().end())
        return std::nullopt;
    return static_cast<std::size_t>(enough - gaussSizes().begin());
}

/// The integral of |c(t)| over [0, 1] by a Gauss rule. c is evaluated as (1 - t)^d times a polynomial in t / (1 - t),
/// and at the mirrored node with the coefficients reversed.
double integral(std::span<const Vector> speed, std::span<const double> binomial, std::size_t rule) {
    const std::size_t degree = speed.size() - 1;
    double sum = 0;
    for (const GaussNode node : gaussNodes(rule)) {
        const double ratio = node.at / (1 - node.at);
        Vector near = binomial[degree] * speed[degree];
        Vector far = binomial[degree] * speed[0];
        for (std::size_t i = degree; i-- > 0;) {
            near = ratio * near + binomial[i] * speed[i];
            far = ratio * far + binomial[i] * speed[degree - i];
        }
        sum += node.weight * power(1 - node.at, degree) * (size(near) + size(far));
    }
    return sum;
}

/// Calls `use` with the pieces of the curve in order. `lower` is a lower bound of the whole length.
template <class Use>
void forEachPiece(Piece& piece, double lower, int depth, const Use& use) {
    const double width = piece.to - piece.from;
    const auto rule = sufficientRule(piece.speed, kSharedError * lower / width);
    if (rule || depth == kDeepest) {
        piece.rule = rule.value_or(0);
        use(piece);
        return;
    }
    const double middle = piece.from / 2 + piece.to / 2;
    Piece left{std::vector<Vector>(piece.speed.size()), piece.from, middle, 0};
    splitInPlace(std::span(piece.speed), std::span(left.speed), 0.5);
    forEachPiece(left, lower, depth + 1, use);
    piece.from = middle;
    forEachPiece(piece, lower, depth + 1, use);
}

/// The curve's derivative divided by its largest component, so that squares neither overflow nor vanish.
struct ScaledSpeed {
    std::vector<Vector> speed;
    double scale = 0;
};

ScaledSpeed scaledSpeed(std::span<const Point> curve) {
    ScaledSpeed result;
    const auto degree = static_cast<double>(curve.size() - 1);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const Vector step = degree * (curve[i + 1] - curve[i]);
        result.speed.push_back(step);
        result.scale = std::max({result.scale, std::abs(step.x), std::abs(step.y)});
    }
    if (result.scale > 0)
        for (Vector& c : result.speed)
            c = c / result.scale;
    return result;
}

/// A lower bound of the length: the polyline through nine points of the curve, whose derivative has these control
/// vectors.
double lowerBound(std::span<const Vector> speed) {
    constexpr int kParts = 8;
    const auto degree = static_cast<double>(speed.size());
    std::vector<Vector> points{{0, 0}};
    for (const Vector c : speed)
        points.push_back(points.back() + c / degree);
    double sum = 0;
    Vector before{0, 0};
    for (int i = 1; i <= kParts; ++i) {
        std::vector<Vector> row = points;
        const Vector here = valueInPlace(std::span(row), static_cast<double>(i) / kParts);
        sum += size(here - before);
        before = here;
    }
    return sum;
}

} // namespace

double arcLength(std::span<const Point> curve) {
    assert(!curve.empty());
    auto [speed, scale] = scaledSpeed(curve);
    if (scale == 0)
        return 0;
    const std::vector<double> binomial = binomials(speed.size() - 1);
    const double lower = lowerBound(speed);
    double sum = 0;
    Piece whole{std::move(speed), 0, 1, 0};
    forEachPiece(whole, lower, 0, [&](const Piece& piece) {
        sum += (piece.to - piece.from) * integral(piece.speed, binomial, piece.rule);
    });
    return scale * sum;
}

double parameterAtLength(std::span<const Point> curve, double length) {
    assert(!curve.empty());
    auto [speed, scale] = scaledSpeed(curve);
    if (scale == 0 || length <= 0)
        return 0;
    const std::vector<double> binomial = binomials(speed.size() - 1);
    const double lower = lowerBound(speed);
    double rest = length / scale;
    std::optional<double> found;
    Piece whole{std::move(speed), 0, 1, 0};
    forEachPiece(whole, lower, 0, [&](const Piece& piece) {
        if (found)
            return;
        const double width = piece.to - piece.from;
        const double all = width * integral(piece.speed, binomial, piece.rule);
        if (rest > all) {
            rest -= all;
            return;
        }
        // Length grows with the parameter, so a bracketed secant cannot miss. The rule of the piece is enough for its
        // parts: their ellipses lie inside its own.
        double low = 0;
        double high = 1;
        double t = all > 0 ? rest / all : 0;
        for (int i = 0; i < 100 && high - low > 1e-16; ++i) {
            std::vector<Vector> end = piece.speed;
            std::vector<Vector> start(end.size());
            splitInPlace(std::span(end), std::span(start), t);
            const double error = width * t * integral(start, binomial, piece.rule) - rest;
            (error > 0 ? high : low) = t;
            const double here = width * size(end.front());
            const double next = t - error / here;
            const double before = t;
            t = next > low && next < high ? next : low / 2 + high / 2;
            if (std::abs(t - before) <= 1e-16)
                break;
        }
        found = piece.from + width * t;
    });
    return found.value_or(1);
}

} // namespace kriva
