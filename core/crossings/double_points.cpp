#include "core/crossings/double_points.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

/// Below this v a loop is smaller than what counts as touching: a cusp, seen through rounding.
constexpr double kLeastLoop = 1e-13;

/// Halvings after which a rectangle is as small as a multiple root can be seen.
constexpr int kDeepest = 56;

/// Rectangles looked at before a segment counts as lying on itself within rounding.
constexpr int kMostCells = 200'000;

/// Roots may lie outside of the segment by rounding.
constexpr double kSlack = 1e-9;

/// (B(s) - B(t)) / (s - t) as a polynomial in u = m - 1/2 and v, coefficients [power of u][power of v].
using Quotient = std::array<std::array<Vector, 3>, Arc::kMostDegree>;

/// The coefficients of the arc in the powers of t - 1/2.
std::array<Vector, Arc::kMostDegree + 1> powersAroundMiddle(const Arc& arc) {
    const std::size_t n = arc.degree;
    // Half of the arc on either side of the middle: differences at the start of the right half are its Taylor
    // coefficients there, by the parameter 2 (t - 1/2).
    auto row = halved(arc).right.points;
    std::array<Vector, Arc::kMostDegree + 1> powers{};
    double factor = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        powers[k] = factor * (row[0] - Point{});
        for (std::size_t i = 0; i + k < n; ++i)
            row[i] = Point{} + (row[i + 1] - row[i]);
        factor *= 2 * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return powers;
}

Quotient quotientOf(const Arc& arc) {
    const auto powers = powersAroundMiddle(arc);
    Quotient quotient{};
    for (std::size_t k = 1; k <= arc.degree; ++k) {
        double binomial = static_cast<double>(k); // C(k, j) for odd j
        for (std::size_t j = 1; j <= k; j += 2) {
            quotient[k - j][(j - 1) / 2] = quotient[k - j][(j - 1) / 2] + binomial * powers[k];
            binomial *= static_cast<double>((k - j) * (k - j - 1)) / static_cast<double>((j + 1) * (j + 2));
        }
    }
    return quotient;
}

struct Place {
    double u = 0;
    double v = 0;
};

struct Local {
    Vector value;
    Vector byU;
    Vector byV;
};

Local evaluate(const Quotient& quotient, Place place) {
    Local local;
    for (std::size_t i = quotient.size(); i-- > 0;) {
        const auto& [c0, c1, c2] = quotient[i];
        local.byU = place.u * local.byU + local.value;
        local.value = place.u * local.value + (c0 + place.v * (c1 + place.v * c2));
        local.byV = place.u * local.byV + (c1 + 2 * place.v * c2);
    }
    return local;
}

/// A rectangle of u and v.
struct Cell {
    double u0, u1, v0, v1;
    [[nodiscard]] Place centre() const { return {u0 / 2 + u1 / 2, v0 / 2 + v1 / 2}; }
};

/// Finds all roots of a quotient with m - h >= 0, m + h <= 1.
class RootSearch {
  public:
    explicit RootSearch(const Quotient& quotient)
        : quotient_(quotient) {}

    std::vector<Place> roots() {
        visit({-0.5, 0.5, 0, 0.25}, 0);
        return std::move(found_);
    }

  private:
    void visit(const Cell& cell, int depth) {
        if (++cells_ > kMostCells)
            return;
        // The nearest u to the middle leaves most room for h.
        const double nearest = cell.u0 > 0 ? cell.u0 : cell.u1 < 0 ? -cell.u1 : 0;
        if (std::sqrt(cell.v0) > 0.5 - nearest + kSlack)
            return;
        const Place centre = cell.centre();
        const Local local = evaluate(quotient_, centre);
        const double turn = cross(local.byU, local.byV);
        const auto rest = restOf(cell, centre);
        if (std::abs(local.value.x) > rest.x || std::abs(local.value.y) > rest.y)
            return;
        if (turn != 0 && decide(cell, local, turn))
            return;
        if (depth == kDeepest) {
            add(centre, cell);
            return;
        }
        const double middle = depth % 2 == 0 ? centre.u : centre.v;
        if (depth % 2 == 0) {
            visit({cell.u0, middle, cell.v0, cell.v1}, depth + 1);
            visit({middle, cell.u1, cell.v0, cell.v1}, depth + 1);
        } else {
            visit({cell.u0, cell.u1, cell.v0, middle}, depth + 1);
            visit({cell.u0, cell.u1, middle, cell.v1}, depth + 1);
        }
    }

    /// How far values in the cell are from the one in its centre at most, by each coordinate.
    [[nodiscard]] Vector restOf(const Cell& cell, Place centre) const {
        const Deviation deviation = deviationOf(cell, centre);
        return {deviation.value.x, deviation.value.y};
    }

    /// Bounds by the Taylor series around the centre: all terms with absolute values.
    struct Deviation {
        Vector value; ///< of the quotient
        Vector byU;   ///< of its derivatives
        Vector byV;
    };
    [[nodiscard]] Deviation deviationOf(const Cell& cell, Place centre) const {
        const Quotient taylor = moved(centre);
        const double ru = (cell.u1 - cell.u0) / 2, rv = (cell.v1 - cell.v0) / 2;
        Deviation deviation;
        for (std::size_t i = 0; i < taylor.size(); ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const Vector c{std::abs(taylor[i][j].x), std::abs(taylor[i][j].y)};
                const auto size = [&](std::size_t p, std::size_t q) { return std::pow(ru, p) * std::pow(rv, q); };
                if (i + j > 0)
                    deviation.value = deviation.value + size(i, j) * c;
                if (i + j > 1 && i > 0)
                    deviation.byU = deviation.byU + static_cast<double>(i) * size(i - 1, j) * c;
                if (i + j > 1 && j > 0)
                    deviation.byV = deviation.byV + static_cast<double>(j) * size(i, j - 1) * c;
            }
        return deviation;
    }

    /// The quotient in powers of the distances from a place.
    [[nodiscard]] Quotient moved(Place place) const {
        Quotient taylor = quotient_;
        const std::size_t n = taylor.size();
        for (std::size_t k = 0; k + 1 < n; ++k)
            for (std::size_t i = n - 1; i-- > k;)
                for (std::size_t j = 0; j < 3; ++j)
                    taylor[i][j] = taylor[i][j] + place.u * taylor[i + 1][j];
        for (auto& [c0, c1, c2] : taylor) {
            c0 = c0 + place.v * (c1 + place.v * c2);
            c1 = c1 + 2 * place.v * c2;
        }
        return taylor;
    }

    /// Whether all roots in the cell are known. With the derivatives multiplied by the inverse of those in the centre,
    /// there is one root at most where they differ from the identity by less than 1 in each row.
    bool decide(const Cell& cell, const Local& local, double turn) {
        const Deviation deviation = deviationOf(cell, cell.centre());
        const auto row = [&](Vector by) { // of the inverse, times a derivative's deviation
            const double first = (std::abs(local.byV.y) * by.x + std::abs(local.byV.x) * by.y) / std::abs(turn);
            const double second = (std::abs(local.byU.y) * by.x + std::abs(local.byU.x) * by.y) / std::abs(turn);
            return Vector{first, second};
        };
        const Vector byU = row(deviation.byU), byV = row(deviation.byV);
        if (byU.x + byV.x >= 1 || byU.y + byV.y >= 1)
            return false;
        Place place = cell.centre();
        for (int step = 0; step < 40; ++step) {
            const Local here = evaluate(quotient_, place);
            const double det = cross(here.byU, here.byV);
            if (det == 0)
                return false;
            const double du = -cross(here.value, here.byV) / det, dv = -cross(here.byU, here.value) / det;
            place = {place.u + du, place.v + dv};
            if (std::abs(place.u) > 2 || std::abs(place.v) > 2)
                return false;
            if (std::abs(du) + std::abs(dv) > 1e-15)
                continue;
            break;
        }
        const double slackU = (cell.u1 - cell.u0) * 1e-6, slackV = (cell.v1 - cell.v0) * 1e-6;
        if (place.u < cell.u0 - slackU || place.u > cell.u1 + slackU || place.v < cell.v0 - slackV ||
            place.v > cell.v1 + slackV)
            return false;
        found_.push_back(place);
        return true;
    }

    /// Cells too small to halve, around a multiple root.
    void add(Place place, const Cell& cell) {
        const double near = 64 * (cell.u1 - cell.u0);
        for (Place& other : found_)
            if (std::abs(other.u - place.u) <= near && std::abs(other.v - place.v) <= near)
                return;
        found_.push_back(place);
    }

    const Quotient& quotient_;
    std::vector<Place> found_;
    int cells_ = 0;
};

/// The quotient of a cubic is a (3 u^2 + v) + b u + c, of which the cross products with a and b leave u and v.
std::vector<Place> rootsOfCubic(const Quotient& quotient) {
    const Vector a = quotient[0][1], b = quotient[1][0], c = quotient[0][0];
    const double turn = cross(a, b);
    if (turn == 0)
        return {};
    const double u = -cross(a, c) / turn;
    return {{u, cross(b, c) / turn - 3 * u * u}};
}

/// A parabola traced forth and back around its middle m: all odd powers of t - m vanish.
std::optional<double> middleOfRetrace(const Quotient& quotient) {
    const Vector fourth = quotient[3][0]; // 4 times the coefficient of the fourth power
    if (fourth == Vector{} || length(quotient[4][0]) > 1e-12 * length(fourth))
        return {};
    const Vector third = quotient[2][0];
    const double u = -dot(third, fourth) / (3 * dot(fourth, fourth));
    double size = 0;
    for (const auto& row : quotient)
        for (const Vector& c : row)
            size = std::max({size, std::abs(c.x), std::abs(c.y)});
    for (const double v : {0.0, 0.125, 0.25}) {
        const Vector value = evaluate(quotient, {u, v}).value;
        if (length(value) > 1e-12 * size)
            return {};
    }
    if (std::abs(u) >= 0.5)
        return {};
    return u + 0.5;
}

} // namespace

SegmentContacts doublePoints(const Arc& arc, const ContactScale& scale) {
    SegmentContacts result;
    if (arc.degree < 3)
        return result;
    const Quotient quotient = quotientOf(arc);
    if (const auto middle = middleOfRetrace(quotient)) {
        const double half = std::min(*middle, 1 - *middle);
        // The first pass forth, the second one back from the same place.
        result.common.push_back({{*middle - half, *middle + half}, {*middle, *middle}});
        return result;
    }
    if (distance(arc.front(), arc.back()) <= scale.touching)
        result.contacts.push_back({0, 1});
    for (const Place place : arc.degree == 3 ? rootsOfCubic(quotient) : RootSearch(quotient).roots()) {
        if (!(place.v > kLeastLoop))
            continue;
        const double h = std::sqrt(place.v);
        if (!(h <= 0.5 - std::abs(place.u) + kSlack))
            continue;
        const Contact contact{std::clamp(0.5 + place.u - h, 0.0, 1.0), std::clamp(0.5 + place.u + h, 0.0, 1.0)};
        if (distance(evaluate(arc, contact.a).at, evaluate(arc, contact.b).at) > scale.touching)
            continue;
        const auto isSame = [&contact](const Contact& other) {
            return std::abs(other.a - contact.a) <= 1e-9 && std::abs(other.b - contact.b) <= 1e-9;
        };
        if (std::ranges::none_of(result.contacts, isSame))
            result.contacts.push_back(contact);
    }
    return result;
}

} // namespace kriva
