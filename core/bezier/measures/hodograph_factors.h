#pragma once

#include "core/geometry/point.h"

#include <array>

namespace kriva {

/// c(t) = constant + linear t + quadratic t^2: the derivative of a cubic or of a parabola.
struct QuadraticHodograph {
    Vector constant;
    Vector linear;
    Vector quadratic;
};

/// The product of two vectors as complex numbers x + iy.
constexpr Vector complexProduct(Vector a, Vector b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// c as a complex polynomial in two factors, (t - D/q) (A t - q) with A, B, D its coefficients and
/// q = -(B + sqrt(B^2 - 4 A D)) / 2, of the two roots the one that does not cancel. The product differs from c by a few
/// roundings of its coefficients.
class HodographFactors {
  public:
    /// None of the coefficients of which the largest is has a square that over- or underflows.
    explicit HodographFactors(const QuadraticHodograph& c);

    /// There are no factors: c is a constant, or A t^2.
    [[nodiscard]] bool isMonomial() const { return q_ == Vector{}; }

    /// |t - D/q| and |A t - q|.
    [[nodiscard, gnu::always_inline]] std::array<double, 2> sizesAt(double t) const {
        const Vector first{q_.x * t - constant_.x, q_.y * t - constant_.y};
        const Vector second{quadratic_.x * t - q_.x, quadratic_.y * t - q_.y};
        return {std::sqrt(dot(first, first)) * inverse_, std::sqrt(dot(second, second))};
    }
    /// |A|.
    [[nodiscard]] double slope() const { return slope_; }

    /// A zero of c; and the other factor, A times the distance from the other zero, at the real part of this one.
    struct Zero {
        Vector at;
        double otherSize = 0;
    };
    [[nodiscard]] Zero firstZero() const;
    /// Not finite where there is none, or beyond the range of doubles.
    [[nodiscard]] Zero secondZero() const;

  private:
    Vector constant_;
    Vector quadratic_;
    Vector q_;
    double inverse_; ///< 1 / |q|
    double slope_;
};

} // namespace kriva
