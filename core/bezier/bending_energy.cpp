#include "core/bezier/bending_energy.h"

#include "core/bezier/curvature.h"
#include "core/polynomial/bernstein_polynomial.h"
#include "core/polynomial/casteljau.h"
#include "core/polynomial/gauss_legendre.h"
#include "core/polynomial/hodograph_forms.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace kriva {

namespace {

/// Relative error of each piece; rounding adds less.
constexpr double kError = 1e-11;

/// The speed, as a share of the polygon's length, below which the energy counts as infinite.
constexpr double kStandstill = 1e-9;

/// Halvings after which the least speed is known to nine digits, wherever it lies.
constexpr int kDeepest = 60;

/// A piece whose hodograph lies around `middle`, all control vectors within `deviation`.
struct Disc {
    double middle = 0;
    double deviation = 0;
};

std::vector<Vector> roundedVectors(const ExactHodograph& c) {
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < c.x.size(); ++i)
        vectors.push_back({static_cast<double>(c.x[i]), static_cast<double>(c.y[i])});
    return vectors;
}

Disc discAround(std::span<const Vector> vectors) {
    Vector low = vectors.front();
    Vector high = vectors.front();
    for (const Vector v : vectors) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y)};
    }
    const Vector middle = low / 2 + high / 2;
    Disc disc{length(middle), 0};
    for (const Vector v : vectors)
        disc.deviation = std::max(disc.deviation, length(v - middle));
    return disc;
}

/// A rule that integrates the integrand X^2 / |c|^5 to kError, as an index of kGaussSizes; nothing where halving is
/// better.
///
/// In the ellipse |t| + |1 - t| <= s a polynomial of degree d with Bernstein coefficients up to C is at most C s^d. So
/// with s^d = middle / (2 deviation) the vector c stays within middle / 2 of its middle, and the integrand below
/// (max |X_i| s^(2 d - 2))^2 / (middle / 2)^5. `mean` is the mean of X^2, a lower bound of the integral times the
/// largest speed's fifth power.
std::optional<std::size_t> sufficientRule(const Disc& disc, std::size_t degree, double largest, double mean) {
    const double s = std::pow(disc.middle / (2 * disc.deviation), 1 / static_cast<double>(degree));
    const double rho = s + std::sqrt(s * s - 1);
    const double growth = largest * largest / mean * std::pow(2 * (1 + disc.deviation / disc.middle), 5);
    const double points = 1 + std::log(64.0 / 30 * growth / (kError * (1 - 1 / (rho * rho)))) / (2 * std::log(rho)) +
                          2 * static_cast<double>(degree - 1) * std::log(s) / std::log(rho);
    const auto enough = std::ranges::lower_bound(kGaussSizes, points);
    // Halving is cheap at low degrees and gains more there than points do.
    if (enough == kGaussSizes.end() || points > std::max(32.0, 12 * std::sqrt(static_cast<double>(degree))))
        return std::nullopt;
    return static_cast<std::size_t>(enough - kGaussSizes.begin());
}

class Energy {
  public:
    explicit Energy(double standstill)
        : standstill_(standstill) {}

    /// Adds the energy of a piece of this width; false where it diverges. Uses up the piece.
    [[nodiscard]] bool add(ExactHodograph& piece, double width, int depth);

    [[nodiscard]] double sum() const { return sum_; }

  private:
    [[nodiscard]] bool addHalves(ExactHodograph& piece, double width, int depth);

    double standstill_;
    double sum_ = 0;
};

bool Energy::addHalves(ExactHodograph& piece, double width, int depth) {
    const std::size_t size = piece.x.size();
    ExactHodograph left{std::vector<DoubleDouble>(size), std::vector<DoubleDouble>(size)};
    splitInPlace(std::span(piece.x), std::span(left.x), 0.5);
    splitInPlace(std::span(piece.y), std::span(left.y), 0.5);
    return add(left, width / 2, depth + 1) && add(piece, width / 2, depth + 1);
}

bool Energy::add(ExactHodograph& piece, double width, int depth) {
    const std::vector<Vector> speed = roundedVectors(piece);
    const Disc disc = discAround(speed);
    if (disc.middle + disc.deviation < standstill_ || (depth == kDeepest && disc.middle < standstill_))
        return false;
    const bool inside = 2 * disc.deviation < disc.middle && disc.middle - disc.deviation >= standstill_;
    if (!inside && depth < kDeepest)
        return addHalves(piece, width, depth);

    std::vector<double> x;
    for (const DoubleDouble& value : turning(piece))
        x.push_back(static_cast<double>(value) / width);
    const double largest = largestCoefficient(x);
    if (largest == 0)
        return true;
    const std::vector<double> squared = product(x, x);
    const double mean = std::accumulate(squared.begin(), squared.end(), 0.0) / static_cast<double>(squared.size());
    const auto rule = sufficientRule(disc, speed.size() - 1, largest, mean);
    if (!rule && depth < kDeepest)
        return addHalves(piece, width, depth);
    for (const GaussNode node : gaussNodes(rule.value_or(0)))
        for (const double t : {node.at, 1 - node.at}) {
            std::vector<Vector> row = speed;
            std::vector<double> turn = x;
            const double here = length(valueInPlace(std::span(row), t));
            const double bend = valueInPlace(std::span(turn), t) / (here * here);
            sum_ += width * node.weight * bend * bend / here;
        }
    return true;
}

} // namespace

std::optional<double> bendingEnergy(std::span<const Point> curve) {
    assert(!curve.empty());
    if (isStraight(curve))
        return 0;
    const double unit = unitOf(curve);
    ExactHodograph hodograph = exactHodograph(curve, unit);
    Energy energy(kStandstill * polygonLength(curve) / unit);
    if (!energy.add(hodograph, 1, 0))
        return std::nullopt;
    return energy.sum() / unit;
}

} // namespace kriva
