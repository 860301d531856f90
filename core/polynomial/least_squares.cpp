#include "core/polynomial/least_squares.h"

#include "core/numbers/double_double_lanes.h"
#include "core/numbers/vector_registers.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

/// Double-doubles with their parts apart and zeros behind them, so that lanes of them are worked on.
class Column {
  public:
    explicit Column(std::size_t size)
        : size_(size)
        , high_((size + kLanes - 1) / kLanes * kLanes)
        , low_(high_.size()) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t sizeWithZeros() const { return high_.size(); }
    [[nodiscard]] DoubleDouble operator[](std::size_t i) const { return {high_[i], low_[i]}; }
    void set(std::size_t i, const DoubleDouble& value) {
        high_[i] = value.high;
        low_[i] = value.low;
    }
    [[nodiscard, gnu::always_inline]] DoubleDoubleLanes lanes(std::size_t from) const {
        return DoubleDoubleLanes::at(&high_[from], &low_[from]);
    }

    static constexpr std::size_t kLanes = DoubleDoubleLanes::kCount;

  private:
    std::size_t size_;
    std::vector<double> high_;
    std::vector<double> low_;
};

DoubleDouble dot(const Column& a, const Column& b) {
    // A sum in each lane: a single one waits for each of its additions.
    DoubleDoubleLanes sums;
    for (std::size_t i = 0; i < a.sizeWithZeros(); i += Column::kLanes)
        sums = sums + a.lanes(i) * b.lanes(i);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Takes away from a column its part along a unit column.
void removePart(Column& column, const Column& unit) {
    const DoubleDouble part = dot(column, unit);
    for (std::size_t i = 0; i < column.sizeWithZeros(); ++i)
        column.set(i, column[i] - part * unit[i]);
}

/// The x of the points mapped to [-1, 1].
Column mappedPlaces(std::span<const Point> points) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x; });
    const DoubleDouble span = exactSum(high->x, -low->x);
    Column places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        places.set(i, (exactSum(points[i].x, -low->x) - exactSum(high->x, -points[i].x)) / span);
    return places;
}

/// Makes a column orthogonal to the unit columns and of length 1; false where double-doubles tell nothing of it but its
/// parts along them.
bool orthonormalise(Column& column, const std::vector<Column>& basis) {
    // Cancellation leaves parts as large as it is strong. Below this factor a second pass is due, and enough (Parlett,
    // The Symmetric Eigenvalue Problem, section 6.9, after Kahan); above it 28 of 32 digits stand.
    constexpr double kStrongCancellation = 1e-3;
    constexpr double kNothing = 0x1p-90; // some 14 bits above their unit
    double before = 0;
    DoubleDouble norm = sqrt(dot(column, column));
    const double whole = norm.high;
    do {
        before = norm.high;
        for (const Column& unit : basis)
            removePart(column, unit);
        norm = sqrt(dot(column, column));
    } while (norm.high < kStrongCancellation * before);
    if (!(norm.high > kNothing * whole))
        return false;
    const DoubleDouble scale = DoubleDouble(1) / norm;
    for (std::size_t i = 0; i < column.sizeWithZeros(); ++i)
        column.set(i, column[i] * scale);
    return true;
}

/// Takes away from the values their part in the polynomials of the degree: what is left are the residuals. Gives the
/// degree that the places tell apart.
int removePolynomial(Column& values, const Column& places, int degree) {
    std::vector<Column> basis;
    basis.reserve(static_cast<std::size_t>(degree) + 1);
    Column next(places.size());
    for (std::size_t i = 0; i < next.size(); ++i)
        next.set(i, 1);
    for (int k = 0; k <= degree; ++k) {
        if (!orthonormalise(next, basis))
            return k - 1;
        removePart(values, next);
        basis.push_back(next);
        for (std::size_t i = 0; i < next.sizeWithZeros(); ++i)
            next.set(i, next[i] * places[i]);
    }
    return degree;
}

/// Sets to zero what only the roundings of the work left, so that points on a polynomial have no residuals.
void clearNoise(Column& residuals, std::span<const Point> points) {
    // Some 14 bits above the unit of double-double arithmetic, 37 below a rounding of the largest value.
    constexpr double kNoise = 0x1p-90;
    double largest = 0;
    for (const Point p : points)
        largest = std::max(largest, std::abs(p.y));
    for (std::size_t i = 0; i < residuals.size(); ++i)
        if (std::abs(residuals[i].high) <= kNoise * largest)
            residuals.set(i, 0);
}

/// Indices of points, the first one farthest out, each further one with the largest product of distances to those
/// before it: Leja's order, in which Newton's form is stable (Reichel, Newton interpolation at Leja points, BIT 30,
/// 1990).
std::vector<std::size_t> spreadPoints(const Column& places, int count) {
    std::vector<double> product;
    product.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        product.push_back(std::abs(places[i].high));
    std::vector<std::size_t> chosen;
    for (int k = 0; k < count; ++k) {
        if (k == 1)
            product.assign(places.size(), 1);
        if (k > 0)
            for (std::size_t i = 0; i < places.size(); ++i)
                product[i] *= abs(places[i] - places[chosen.back()]).high;
        chosen.push_back(static_cast<std::size_t>(std::max_element(product.begin(), product.end()) - product.begin()));
    }
    return chosen;
}

/// Taken in units of the largest value, so that small squares do not underflow.
double rootMeanSquare(const Column& values, double largest) {
    if (largest == 0)
        return 0;
    DoubleDouble sum;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DoubleDouble inUnits = values[i] / largest;
        sum = sum + inUnits * inUnits;
    }
    return largest * sqrt(sum / static_cast<double>(values.size())).high;
}

/// For more points than coefficients.
Fit approximated(std::span<const Point> points, int degree) {
    const Column places = mappedPlaces(points);
    Column residuals(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        residuals.set(i, points[i].y);
    const int toldApart = removePolynomial(residuals, places, degree);
    clearNoise(residuals, points);

    Fit fit;
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    for (const std::size_t i : spreadPoints(places, toldApart + 1)) {
        nodes.push_back(points[i].x);
        values.push_back(points[i].y - residuals[i]);
    }
    fit.polynomial = interpolate(nodes, values);
    for (int k = toldApart; k < degree; ++k) {
        fit.polynomial.nodes.push_back(nodes.back());
        fit.polynomial.coefficients.push_back(fit.polynomial.number(0));
    }
    for (std::size_t i = 0; i < residuals.size(); ++i)
        fit.maxError = std::max(fit.maxError, std::abs(residuals[i].high));
    fit.rms = rootMeanSquare(residuals, fit.maxError);
    return fit;
}

#ifdef __x86_64__
/// The same to the last bit, with the processor's own fused multiply-add, which not every one has, in place of calls of
/// the library's: in half the time.
__attribute__((flatten, target("avx2,fma"))) Fit approximatedWithFma(std::span<const Point> points, int degree) {
    return approximated(points, degree);
}
#endif

} // namespace

Fit fitThroughAll(std::span<const Point> points) {
    std::vector<double> nodes;
    std::vector<DoubleDouble> values;
    for (const Point p : points) {
        nodes.push_back(p.x);
        values.emplace_back(p.y);
    }
    return {interpolate(nodes, values)};
}

Fit fitLeastSquares(std::span<const Point> points, int degree) {
    assert(!points.empty() && degree >= 0);
    if (points.size() <= static_cast<std::size_t>(degree) + 1)
        return fitThroughAll(points);
    clearVectorRegisters();
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return approximatedWithFma(points, degree);
#endif
    return approximated(points, degree);
}

} // namespace kriva
