#include "core/intersections/loops/loop_quotient.h"

#include <cmath>

namespace kriva {
namespace {

/// A root on the border of a rectangle is not lost to rounding.
constexpr double kBorder = 1e-9;

using Powers = std::array<Vector, Arc::kMostDegree + 1>;

/// The coefficients of the arc in the powers of t - 1/2: differences at the start of its right half, which has the
/// parameter 2 (t - 1/2).
Powers powersAroundMiddle(const Arc& arc) {
    const std::size_t n = arc.degree;
    auto row = halved(arc).right.points;
    Powers powers{};
    double factor = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        powers[k] = factor * (row[0] - Point{});
        for (std::size_t i = 0; i + k < n; ++i)
            row[i] = Point{} + (row[i + 1] - row[i]);
        factor *= 2 * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return powers;
}

double largest(const LocalQuotient& local, std::size_t i, std::size_t j) {
    return std::pow(local.u, i) * std::pow(local.v, j);
}

Vector absolute(Vector a) {
    return {std::abs(a.x), std::abs(a.y)};
}

} // namespace

LoopQuotient loopQuotientOf(const Arc& arc) {
    const Powers powers = powersAroundMiddle(arc);
    LoopQuotient quotient;
    for (std::size_t k = 1; k <= arc.degree; ++k) {
        auto binomial = static_cast<double>(k); // C(k, j) for odd j
        for (std::size_t j = 1; j <= k; j += 2) {
            Vector& term = quotient.terms[k - j][(j - 1) / 2];
            term = term + binomial * powers[k];
            binomial *= static_cast<double>((k - j) * (k - j - 1)) / static_cast<double>((j + 1) * (j + 2));
        }
    }
    return quotient;
}

LoopValue evaluate(const LoopQuotient& quotient, LoopPlace place) {
    LoopValue here;
    for (std::size_t i = quotient.terms.size(); i-- > 0;) {
        const auto& [c0, c1, c2] = quotient.terms[i];
        here.byU = place.u * here.byU + here.value;
        here.value = place.u * here.value + (c0 + place.v * (c1 + place.v * c2));
        here.byV = place.u * here.byV + (c1 + 2 * place.v * c2);
    }
    return here;
}

LocalQuotient around(const LoopQuotient& quotient, LoopPlace centre, double u, double v) {
    LocalQuotient local{quotient, u, v};
    auto& terms = local.quotient.terms;
    // Horner's scheme again and again moves the centre.
    for (std::size_t k = 0; k + 1 < terms.size(); ++k)
        for (std::size_t i = terms.size() - 1; i-- > k;)
            for (std::size_t j = 0; j < terms[i].size(); ++j)
                terms[i][j] = terms[i][j] + centre.u * terms[i + 1][j];
    for (auto& [c0, c1, c2] : terms) {
        c0 = c0 + centre.v * (c1 + centre.v * c2);
        c1 = c1 + 2 * centre.v * c2;
    }
    return local;
}

bool hasNoRoot(const LocalQuotient& local, Vector along) {
    const auto& terms = local.quotient.terms;
    double deviation = 0;
    for (std::size_t i = 0; i < terms.size(); ++i)
        for (std::size_t j = 0; j < terms[i].size(); ++j)
            if (i + j > 0)
                deviation += largest(local, i, j) * std::abs(dot(along, terms[i][j]));
    return std::abs(dot(along, terms[0][0])) > (1 + kBorder) * deviation;
}

Vector deviationByU(const LocalQuotient& local) {
    const auto& terms = local.quotient.terms;
    Vector deviation;
    for (std::size_t i = 1; i < terms.size(); ++i)
        for (std::size_t j = 0; j < terms[i].size(); ++j)
            if (i + j > 1)
                deviation = deviation + static_cast<double>(i) * largest(local, i - 1, j) * absolute(terms[i][j]);
    return deviation;
}

Vector deviationByV(const LocalQuotient& local) {
    const auto& terms = local.quotient.terms;
    Vector deviation;
    for (std::size_t i = 0; i < terms.size(); ++i)
        for (std::size_t j = 1; j < terms[i].size(); ++j)
            if (i + j > 1)
                deviation = deviation + static_cast<double>(j) * largest(local, i, j - 1) * absolute(terms[i][j]);
    return deviation;
}

} // namespace kriva
