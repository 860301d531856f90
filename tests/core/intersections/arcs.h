#pragma once

#include "core/bezier/subdivide.h"
#include "core/intersections/contacts/segment_contacts.h"
#include "tests/support/any_curve.h"

#include <cmath>
#include <gmock/gmock.h>

/// Arcs whose places are known, and any arcs.
namespace kriva::test {

/// A frame in which the curves of anyCurve() have about the size 1.
inline const ArcFrame kFrame{{0, 0}, 1024};

inline const ContactScale kScale;
inline constexpr double kTouching = 1e-12;

/// Its top, (2, 3), is at 1/2.
inline const Points kArch{{0, 0}, {0, 4}, {4, 4}, {4, 0}};

/// Near two parameters.
[[nodiscard]] inline auto isAt(double a, double b, double allowed = 1e-7) {
    return testing::AllOf(testing::Field(&Contact::a, testing::DoubleNear(a, allowed)),
                          testing::Field(&Contact::b, testing::DoubleNear(b, allowed)));
}

/// An arc whose coordinates are the segment's.
[[nodiscard]] inline Arc plainArc(std::span<const Point> segment) {
    return arcOf(segment, {});
}

/// Any segment of degree 1 to 5 in the frame; its points may coincide.
[[nodiscard]] inline rc::Gen<Arc> anyArc(int leastDegree = 1) {
    return rc::gen::map(anyCurve(leastDegree, 5), [](const Points& segment) { return arcOf(segment, kFrame); });
}

/// Any two parameters in order, at least 1/16 apart.
[[nodiscard]] inline rc::Gen<std::pair<double, double>> anyStretch() {
    return rc::gen::mapcat(rc::gen::inRange(0, 16), [](int from) {
        return rc::gen::map(rc::gen::inRange(from + 1, 17),
                            [from](int to) { return std::pair(from / 16.0, to / 16.0); });
    });
}

/// The Bernstein coefficients of the Chebyshev polynomial T_n(u), u from -1 to 1, raised to a degree of at most 5.
/// Source: the blossom of u^k is the mean of the products of k arguments (Ramshaw, Blossoms are polar forms, CAGD 6,
/// 1989), which here are -1 and 1.
[[nodiscard]] inline std::vector<double> chebyshev(std::size_t n, std::size_t degree) {
    constexpr double kPowers[6][6] = {{1}, {0, 1}, {-1, 0, 2}, {0, -3, 0, 4}, {1, 0, -8, 0, 8}, {0, 5, 0, -20, 0, 16}};
    std::vector<double> coefficients;
    for (std::size_t ones = 0; ones <= degree; ++ones) {
        std::vector<double> sums{1}; // of the products, by how many arguments they have
        for (std::size_t i = 0; i < degree; ++i) {
            sums.push_back(0);
            for (std::size_t k = sums.size(); --k > 0;)
                sums[k] += (i < ones ? 1 : -1) * sums[k - 1];
        }
        double value = 0, binomial = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            value += kPowers[n][k] * sums[k] / binomial;
            binomial *= static_cast<double>(degree - k) / static_cast<double>(k + 1);
        }
        coefficients.push_back(value);
    }
    return coefficients;
}

/// The curve (T_p(u), T_q(u)) of degree max(p, q), u = 2 t - 1.
[[nodiscard]] inline Points chebyshevCurve(std::size_t p, std::size_t q) {
    const std::size_t degree = std::max(p, q);
    const std::vector<double> x = chebyshev(p, degree), y = chebyshev(q, degree);
    Points points;
    for (std::size_t i = 0; i <= degree; ++i)
        points.push_back({x[i], y[i]});
    return points;
}

/// The same polynomial curve from one parameter to another, which may lie outside of [0, 1].
[[nodiscard]] inline Points stretched(std::span<const Point> curve, double from, double to) {
    Points points;
    std::vector<double> arguments(curve.size() - 1, from);
    points.push_back(blossom(curve, arguments));
    for (double& argument : arguments) {
        argument = to;
        points.push_back(blossom(curve, arguments));
    }
    return points;
}

/// Whether a control polygon is neither straight nor nearly so: what lies on a line overlaps itself and others.
[[nodiscard]] inline bool isBent(std::span<const Point> segment) {
    double area = 0;
    for (const Point p : segment)
        for (const Point q : segment)
            area = std::max(area, std::abs(cross(p - segment.front(), q - segment.front())));
    return area > 1;
}

/// A curve of a degree between the two given that is bent.
[[nodiscard]] inline rc::Gen<Points> anyBentCurve(int leastDegree, int mostDegree) {
    return rc::gen::suchThat(anyCurve(leastDegree, mostDegree), [](const Points& curve) { return isBent(curve); });
}

} // namespace kriva::test
