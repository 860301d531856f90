#include "core/bezier/measures/arc_length.h"

#include "core/bezier/measures/speed_integral.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/gauss_legendre.h"
#include "core/polynomial/hodograph_forms.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

namespace kriva {

namespace {

/// How exact the length of a piece must be, relative to itself, if it is at most this share of the whole.
struct Accuracy {
    double share = 0;
    double error = 0;
};

/// A short piece may be off by 1e-15 of the whole; a cusp has less than 200 of them. In all this stays below 1e-12.
constexpr std::array<Accuracy, 4> kAccuracies{{{1e-15, 1}, {1e-10, 1e-5}, {1e-6, 1e-9}, {1e9, 1e-13}}};

/// Halvings after which a piece is too short to matter in any curve.
constexpr int kDeepest = 60;

/// Gauss points of one piece: at low degree halving is cheap and helps more, at high degree it is not.
constexpr double kMostPoints = 24;
constexpr double kMostPointsByDegree = 9;

/// Half the sum of the axes of the smallest Bernstein ellipse in which an integrand within 3 m of m must be analytic
/// for a Gauss rule to be as exact as asked, relative to m: 32/5 rho^(2 - 2 N) / (1 - rho^-2) <= error. In this ellipse
/// around [0, 1], |t| + |1 - t| <= (rho + 1 / rho) / 2.
constexpr double axisNeeded(int points, double error) {
    double low = 1;
    double high = 1e8;
    for (int i = 0; i < 60; ++i) {
        const double rho = low / 2 + high / 2;
        const double decay = power(1 / rho, static_cast<std::size_t>(2 * points - 2));
        const bool enough = decay <= error / 6.4 * (1 - 1 / (rho * rho));
        (enough ? high : low) = rho;
    }
    return high / 2 + 1 / (2 * high);
}

/// axisNeeded() by accuracy and rule.
constexpr auto kAxes = [] {
    std::array<std::array<double, kGaussSizes.size()>, kAccuracies.size()> axes{};
    for (std::size_t i = 0; i < kAccuracies.size(); ++i)
        for (std::size_t rule = 0; rule < kGaussSizes.size(); ++rule)
            axes[i][rule] = axisNeeded(kGaussSizes[rule], kAccuracies[i].error);
    return axes;
}();

/// The smallest Gauss rule that is enough for a piece with this derivative, of which the whole curve is at least
/// `whole` long in units of the piece's parameter; nothing where it is better to halve the piece.
///
/// Where the derivative c, and so its conjugate polynomial, is within the size of the middle of it, both have no zero:
/// there the speed sqrt(c conj(c)) is analytic and within three times the middle's size of it.
std::optional<std::size_t> sufficientRule(std::span<const Vector> speed, double whole) {
    const std::size_t degree = speed.size() - 1;
    const Spread spread = spreadOf(speed);
    const double longest = spread.middle + spread.half + spread.rest;
    std::size_t accuracy = 0;
    while (accuracy + 1 < kAccuracies.size() && longest > kAccuracies[accuracy].share * whole)
        ++accuracy;
    if (kAccuracies[accuracy].error == 1)
        return 0;
    const double most = std::max(kMostPoints, kMostPointsByDegree * std::sqrt(static_cast<double>(degree)));
    for (std::size_t rule = 0; rule < kGaussSizes.size() && kGaussSizes[rule] <= most; ++rule) {
        const double axis = kAxes[accuracy][rule];
        if (axis * spread.half + power(axis, degree) * spread.rest < spread.middle)
            return rule;
    }
    return std::nullopt;
}

/// The integral of |c(t)| over [0, 1] by a Gauss rule.
template <class Row>
double integral(Row speed, std::size_t rule) {
    scaleByBinomials(speed);
    const std::span<const Vector> scaled(speed);
    double sum = 0;
    const auto add = [&](const GaussNode& node, const MirroredValues<Vector>& values) {
        sum += node.weight * (size(values.near) + size(values.far));
    };
    std::span<const GaussNode> nodes = gaussNodes(rule);
    const auto addTogether = [&]<std::size_t... k>(std::index_sequence<k...>) {
        for (; nodes.size() >= sizeof...(k); nodes = nodes.subspan(sizeof...(k))) {
            const auto values = mirroredValues(scaled, std::array{nodes[k].at...});
            (add(nodes[k], values[k]), ...);
        }
    };
    if (scaled.size() >= kLongRow)
        addTogether(std::make_index_sequence<kTogetherInLongRow>());
    addTogether(std::make_index_sequence<4>()); // as many as the registers of SSE2 hold
    for (const GaussNode& node : nodes)
        add(node, mirroredValues(scaled, node.at));
    return sum;
}

/// A part of the curve on which one Gauss rule gives the length. Row is a container of control vectors.
template <class Row>
struct Piece {
    Row speed; ///< the derivative by the curve's parameter
    double from = 0;
    double to = 1;
    std::size_t rule = 0;

    [[nodiscard]] double width() const { return to - from; }
    [[nodiscard]] double length() const { return width() * integral(speed, rule); }
};

/// Calls `use` with the pieces of the curve in order, until it returns false. `whole` is a lower bound of the length.
template <class Row, class Use>
bool forEachPiece(Piece<Row>& piece, double whole, int depth, const Use& use) {
    const auto rule = sufficientRule(piece.speed, whole / piece.width());
    if (rule || depth == kDeepest) {
        piece.rule = rule.value_or(0);
        return use(piece);
    }
    const double middle = piece.from / 2 + piece.to / 2;
    Piece<Row> left{piece.speed, piece.from, middle, 0};
    splitInPlace(std::span<Vector>(piece.speed), std::span<Vector>(left.speed), 0.5);
    piece.from = middle;
    return forEachPiece(left, whole, depth + 1, use) && forEachPiece(piece, whole, depth + 1, use);
}

/// A lower bound of the length, from the polyline through five points of the curve.
template <class Row>
double lowerBound(const Row& speed) {
    double sum = 0;
    Row rest = speed;
    Row part = speed;
    for (int parts = 4; parts > 0; --parts) {
        splitInPlace(std::span<Vector>(rest), std::span<Vector>(part), 1.0 / parts);
        Vector chord;
        for (const Vector c : part)
            chord = chord + c;
        sum += size(chord) / 4;
    }
    return sum / static_cast<double>(speed.size());
}

/// The largest component of a side of the control polygon.
double largestSide(std::span<const Point> curve) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        largest = std::max({largest, std::abs(curve[i + 1].x - curve[i].x), std::abs(curve[i + 1].y - curve[i].y)});
    return largest;
}

/// Calls `use` with the pieces of the curve divided by `scale`, so that squares neither overflow nor vanish.
template <class Row, class Use>
void forEachPieceOf(std::span<const Point> curve, double scale, Row row, const Use& use) {
    const auto degree = static_cast<double>(curve.size() - 1);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        row[i] = (curve[i + 1] - curve[i]) / scale * degree;
    Piece<Row> all{row, 0, 1, 0};
    forEachPiece(all, lowerBound(row), 0, use);
}

/// The same, with rows of fixed size at the degrees that splines have: they need no heap.
template <class Use>
void forEachScaledPiece(std::span<const Point> curve, double scale, const Use& use) {
    switch (curve.size()) {
    case 3:
        return forEachPieceOf(curve, scale, std::array<Vector, 2>{}, use);
    case 4:
        return forEachPieceOf(curve, scale, std::array<Vector, 3>{}, use);
    case 5:
        return forEachPieceOf(curve, scale, std::array<Vector, 4>{}, use);
    case 6:
        return forEachPieceOf(curve, scale, std::array<Vector, 5>{}, use);
    default:
        return forEachPieceOf(curve, scale, std::vector<Vector>(curve.size() - 1), use);
    }
}

/// The length of a parabola or a cubic whose largest side has a square and a fourth power within the range of doubles.
double lengthOfLowDegree(std::span<const Point> curve) {
    const Vector first = curve[1] - curve[0];
    const Vector second = curve[2] - curve[1];
    if (curve.size() == 3)
        return integralOfSpeed({2 * first, 2 * (second - first), {}});
    const Vector third = curve[3] - curve[2];
    return integralOfSpeed({3 * first, 6 * (second - first), 3 * ((third - second) - (second - first))});
}

/// The same of any.
double lengthOfLowDegree(std::span<const Point> curve, double largest) {
    constexpr double kLeast = 1e-50;
    constexpr double kMost = 1e50;
    if (kLeast < largest && largest < kMost)
        return lengthOfLowDegree(curve);
    const double unit = std::exp2(std::ilogb(largest)); // a power of two, so that dividing by it changes no digit
    Points scaled;
    for (const Point p : curve)
        scaled.push_back(Point{} + (p - curve[0]) / unit);
    return unit * lengthOfLowDegree(scaled);
}

/// The local parameter at which a piece has run through `rest` of its length. The length grows with the parameter, so
/// Newton's method in a bracket cannot miss; the rule of the piece is enough for its parts, whose ellipses lie inside
/// its own.
template <class Row>
double parameterInPiece(const Piece<Row>& piece, double rest) {
    double low = 0;
    double high = 1;
    double t = 0.5;
    // Newton's steps double the digits; 60 halvings reach the last one without them.
    for (int step = 0; step < 60; ++step) {
        Row end = piece.speed;
        Row start = piece.speed;
        splitInPlace(std::span<Vector>(end), std::span<Vector>(start), t);
        const double excess = piece.width() * t * integral(start, piece.rule) - rest;
        (excess > 0 ? high : low) = t;
        const double next = t - excess / (piece.width() * size(end.front()));
        const double before = t;
        t = low < next && next < high ? next : low / 2 + high / 2;
        if (std::abs(t - before) <= 1e-16)
            break;
    }
    return t;
}

} // namespace

double arcLength(std::span<const Point> curve) {
    assert(!curve.empty());
    if (curve.size() <= 2)
        return distance(curve.front(), curve.back());
    const double scale = largestSide(curve);
    if (scale == 0)
        return 0;
    if (curve.size() <= 4)
        return lengthOfLowDegree(curve, scale);
    double sum = 0;
    forEachScaledPiece(curve, scale, [&](const auto& piece) {
        sum += piece.length();
        return true;
    });
    return scale * sum;
}

double parameterAtLength(std::span<const Point> curve, double length) {
    assert(!curve.empty());
    const double scale = largestSide(curve);
    if (scale == 0 || length <= 0)
        return 0;
    double rest = length / scale;
    double found = 1;
    forEachScaledPiece(curve, scale, [&](const auto& piece) {
        const double all = piece.length();
        if (rest > all) {
            rest -= all;
            return true;
        }
        found = piece.from + piece.width() * parameterInPiece(piece, rest);
        return false;
    });
    return found;
}

} // namespace kriva
