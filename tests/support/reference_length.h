#pragma once

#include "core/geometry/point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kriva::test {

/// Lengths by adaptive Gauss quadrature with 24 points in a wider floating-point type, a method that shares nothing
/// with the one under test but Gauss's name.
template <class Real>
class ReferenceLength {
  public:
    /// Pieces are halved until that changes their length by less than this share of the polygon's.
    explicit ReferenceLength(Real share)
        : share_(share) {
        for (int i = 0; i < kPoints; ++i) {
            Real x =
                std::cos(std::numbers::pi_v<long double> * (static_cast<long double>(i) + 0.75L) / (kPoints + 0.5L));
            Real slope = 0;
            for (int step = 0; step < 10; ++step) {
                Real before = 1;
                Real value = x;
                for (int k = 2; k <= kPoints; ++k) {
                    const auto m = static_cast<Real>(k);
                    const Real next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
                    before = value;
                    value = next;
                }
                slope = kPoints * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            nodes_.push_back({x, 2 / ((1 - x * x) * slope * slope)});
        }
    }

    [[nodiscard]] double operator()(std::span<const Point> curve) const {
        const auto degree = static_cast<Real>(curve.size() - 1);
        std::vector<Real> x, y;
        Real polygon = 0;
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            x.push_back(degree * (static_cast<Real>(curve[i + 1].x) - static_cast<Real>(curve[i].x)));
            y.push_back(degree * (static_cast<Real>(curve[i + 1].y) - static_cast<Real>(curve[i].y)));
            polygon += root(x.back() * x.back() + y.back() * y.back()) / degree;
        }
        // One pair of rows for all values: this runs a million times.
        std::vector<Real> a = x;
        std::vector<Real> b = y;
        const auto speed = [&](Real t) {
            std::ranges::copy(x, a.begin());
            std::ranges::copy(y, b.begin());
            Real* const rowA = a.data();
            Real* const rowB = b.data();
            for (std::size_t count = x.size(); count > 1; --count)
                for (std::size_t i = 0; i + 1 < count; ++i) {
                    rowA[i] += t * (rowA[i + 1] - rowA[i]);
                    rowB[i] += t * (rowB[i + 1] - rowB[i]);
                }
            return root(rowA[0] * rowA[0] + rowB[0] * rowB[0]);
        };
        return static_cast<double>(adaptive(speed, 0, 1, gauss(speed, 0, 1), share_ * polygon, 0));
    }

  private:
    static constexpr int kPoints = 24;
    struct Node {
        Real at;
        Real weight;
    };

    /// One step of Heron's method doubles the digits of the long double's root.
    static Real root(Real square) {
        const auto near = static_cast<Real>(std::sqrt(static_cast<long double>(square)));
        return near > 0 ? (near + square / near) / 2 : near;
    }
    template <class F>
    [[nodiscard]] Real gauss(const F& f, Real from, Real to) const {
        Real sum = 0;
        for (const Node node : nodes_)
            sum += node.weight * f((from + to) / 2 + (to - from) / 2 * node.at);
        return sum * (to - from) / 2;
    }
    template <class F>
    [[nodiscard]] Real adaptive(const F& f, Real from, Real to, Real whole, Real allowed, int depth) const {
        const Real middle = (from + to) / 2;
        const Real left = gauss(f, from, middle);
        const Real right = gauss(f, middle, to);
        const Real change = left + right - whole;
        if (depth > 45 || (change < allowed && -change < allowed))
            return left + right;
        return adaptive(f, from, middle, left, allowed, depth + 1) + adaptive(f, middle, to, right, allowed, depth + 1);
    }

    Real share_;
    std::vector<Node> nodes_;
};

} // namespace kriva::test
