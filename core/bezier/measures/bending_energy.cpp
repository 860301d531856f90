#include "core/bezier/measures/bending_energy.h"

#include "core/bezier/measures/curvature.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/gauss_legendre.h"
#include "core/polynomial/hodograph_forms.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

/// Relative error of each piece; rounding adds less.
constexpr double kError = 1e-11;

/// The speed, as a share of the polygon's length, below which the energy counts as infinite.
constexpr double kStandstill = 1e-9;

/// Halvings after which the least speed is known to nine digits, wherever it lies.
constexpr int kDeepestSpeed = 60;

/// Doubles are enough for a piece whose speed is at least this share of the largest one, and whose c x c' is at least
/// this share of the products it is the difference of: what cancels leaves twelve digits.
constexpr double kPlain = 1e-3;

/// Gauss points of one piece: at low degree halving is cheap and helps more, at high degree it is not.
constexpr double kMostEnergyPoints = 32;
constexpr double kMostEnergyPointsByDegree = 12;

enum class Outcome { done, diverges, imprecise };

/// Nearly the largest s at which s half + s^degree rest, a convex function of s, is at most half the middle.
double ellipseAxis(const Spread& spread, std::size_t degree) {
    const double target = spread.middle / 2;
    const auto order = static_cast<double>(degree);
    // Either term alone bounds s; beyond 1000 nothing is gained.
    double s = std::min({1e3, target / spread.half, std::pow(target / spread.rest, 1 / order)});
    const auto reach = [&] { return s * spread.half + power(s, degree) * spread.rest; };
    for (int step = 0; step < 3 && reach() > target; ++step)
        s -= (reach() - target) * s / (s * spread.half + order * power(s, degree) * spread.rest);
    // A convex function that is 0 at 0 grows at least in proportion: this makes sure of the bound.
    return s * std::min(1.0, target / reach());
}

/// A bound of the error of a Gauss rule of so many points for the integrand X^2 / |c|^5 over [0, 1], where in the
/// Bernstein ellipse |t| + |1 - t| <= s c stays within half its middle's size of the middle.
///
/// A polynomial of degree d with Bernstein coefficients up to C is at most C s^d there. So the integrand is at most
/// (max |X_i| s^(2 d - 2))^2 / (middle / 2)^5.
struct ErrorBound {
    double rho = 0;
    double largest = 0; ///< of the integrand in the ellipse

    [[nodiscard]] double operator()(double points) const {
        return 64.0 / 30 * largest * std::pow(rho, 2 - 2 * points) / (1 - 1 / (rho * rho));
    }
    /// Points at which the bound is `error`.
    [[nodiscard]] double pointsFor(double error) const {
        return 1 + std::log(64.0 / 30 * largest / (error * (1 - 1 / (rho * rho)))) / (2 * std::log(rho));
    }
};

template <class T>
class Energy {
  public:
    /// The derivative of the curve in some unit, and the least speed in that unit that is no standstill.
    Energy(const Hodograph<T>& hodograph, double standstill)
        : standstill_(standstill)
        , fastest_(std::max(largestCoefficient(hodograph.x), largestCoefficient(hodograph.y))) {}

    /// Adds the energy of a piece of this width, which is used up.
    [[nodiscard]] Outcome add(Hodograph<T>& piece, double width, int depth);

    [[nodiscard]] double sum() const { return sum_; }

  private:
    [[nodiscard]] Outcome addHalves(Hodograph<T>& piece, double width, int depth);
    [[nodiscard]] bool isImprecise(const Spread& spread, double largestTurn) const;
    [[nodiscard]] std::optional<double> integral(std::vector<Vector>& speed, std::vector<double>& turn,
                                                 const Spread& spread, bool last) const;

    double standstill_;
    double fastest_;
    double sum_ = 0;
};

template <class T>
Outcome Energy<T>::addHalves(Hodograph<T>& piece, double width, int depth) {
    Hodograph<T> left = piece;
    splitInPlace(std::span(piece.x), std::span(left.x), 0.5);
    splitInPlace(std::span(piece.y), std::span(left.y), 0.5);
    const Outcome outcome = add(left, width / 2, depth + 1);
    return outcome == Outcome::done ? add(piece, width / 2, depth + 1) : outcome;
}

template <class T>
bool Energy<T>::isImprecise(const Spread& spread, double largestTurn) const {
    if (!std::is_same_v<T, double>)
        return false;
    return spread.middle < kPlain * fastest_ || largestTurn < kPlain * spread.middle * (spread.half + spread.rest);
}

/// The integral over the local parameter; nothing where halving is better, unless this is the last chance. Uses up the
/// coefficients.
template <class T>
std::optional<double> Energy<T>::integral(std::vector<Vector>& speed, std::vector<double>& turn, const Spread& spread,
                                          bool last) const {
    const std::size_t degree = speed.size() - 1;
    const double s = ellipseAxis(spread, degree);
    if (!(s > 1) && !last)
        return std::nullopt;
    const double highest = largestCoefficient(turn) * power(s, 2 * degree - 2);
    const ErrorBound bound{s + std::sqrt(s * s - 1), highest * highest / std::pow(spread.middle / 2, 5)};
    // A guess of the integral, from which the number of points follows; the sum itself then tells whether it was right.
    const double guess = largestCoefficient(turn) * largestCoefficient(turn) / 16 / std::pow(spread.middle, 5);
    const auto enough = std::ranges::lower_bound(kGaussSizes, bound.pointsFor(kError * guess));
    const double most = std::max(kMostEnergyPoints, kMostEnergyPointsByDegree * std::sqrt(static_cast<double>(degree)));
    if ((enough == kGaussSizes.end() || *enough > most) && !last)
        return std::nullopt;
    const auto rule = static_cast<std::size_t>(std::min(enough, kGaussSizes.end() - 1) - kGaussSizes.begin());
    scaleByBinomials(speed);
    scaleByBinomials(turn);
    double sum = 0;
    for (const GaussNode node : gaussNodes(rule)) {
        const auto c = mirroredValues(std::span<const Vector>(speed), node.at);
        const auto x = mirroredValues(std::span<const double>(turn), node.at);
        const double near = dot(c.near, c.near);
        const double far = dot(c.far, c.far);
        sum += node.weight *
               (x.near * x.near / (near * near * std::sqrt(near)) + x.far * x.far / (far * far * std::sqrt(far)));
    }
    if (bound(kGaussSizes[rule]) > kError * sum && !last)
        return std::nullopt;
    return sum;
}

template <class T>
Outcome Energy<T>::add(Hodograph<T>& piece, double width, int depth) {
    std::vector<Vector> speed;
    for (std::size_t i = 0; i < piece.x.size(); ++i)
        speed.push_back({static_cast<double>(piece.x[i]), static_cast<double>(piece.y[i])});
    const Spread spread = spreadOf(speed);
    const double off = spread.half + spread.rest;
    const bool last = depth == kDeepestSpeed;
    if (spread.middle + off < standstill_ || (last && spread.middle < standstill_))
        return Outcome::diverges;
    if ((2 * off >= spread.middle || spread.middle - off < standstill_) && !last)
        return addHalves(piece, width, depth);

    std::vector<double> turn;
    for (const T& value : turning(piece))
        turn.push_back(static_cast<double>(value) / width);
    const double largest = largestCoefficient(turn);
    if (isImprecise(spread, largest * width))
        return Outcome::imprecise;
    if (largest == 0)
        return Outcome::done;
    const auto energy = integral(speed, turn, spread, last);
    if (!energy)
        return addHalves(piece, width, depth);
    sum_ += width * *energy;
    return Outcome::done;
}

/// The energy in 1/unit, or why there is none.
template <class T>
std::optional<double> energyIn(double unit, std::span<const Point> curve, Outcome& outcome) {
    auto hodograph = hodographIn<T>(unit, curve);
    Energy<T> energy(hodograph, kStandstill * polygonLength(curve) / unit);
    outcome = energy.add(hodograph, 1, 0);
    return outcome == Outcome::done ? std::optional(energy.sum()) : std::nullopt;
}

} // namespace

std::optional<double> bendingEnergy(std::span<const Point> curve) {
    assert(!curve.empty());
    if (isStraight(curve))
        return 0;
    const double unit = unitOf(curve);
    Outcome outcome{};
    auto energy = energyIn<double>(unit, curve, outcome);
    if (outcome == Outcome::imprecise)
        energy = energyIn<DoubleDouble>(unit, curve, outcome);
    if (!energy)
        return std::nullopt;
    return *energy / unit;
}

} // namespace kriva
