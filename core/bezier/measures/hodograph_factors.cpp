#include "core/bezier/measures/hodograph_factors.h"

namespace kriva {

namespace {

double absolute(Vector z) {
    return std::sqrt(dot(z, z));
}

/// The root with a real part of at least 0.
Vector complexRoot(Vector z) {
    const double larger = std::sqrt((absolute(z) + std::abs(z.x)) / 2);
    if (larger == 0)
        return {};
    const double smaller = z.y / (2 * larger);
    return z.x >= 0 ? Vector{larger, smaller} : Vector{std::abs(smaller), std::copysign(larger, z.y)};
}

Vector stableHalf(const QuadraticHodograph& c) {
    const Vector root = complexRoot(complexProduct(c.linear, c.linear) - 4 * complexProduct(c.quadratic, c.constant));
    return (dot(c.linear, root) >= 0 ? c.linear + root : c.linear - root) / -2;
}

} // namespace

HodographFactors::HodographFactors(const QuadraticHodograph& c)
    : constant_(c.constant)
    , quadratic_(c.quadratic)
    , q_(stableHalf(c))
    , inverse_(1 / absolute(q_))
    , slope_(absolute(c.quadratic)) {}

HodographFactors::Zero HodographFactors::firstZero() const {
    const Vector conjugate = Vector{q_.x, -q_.y} * inverse_ * inverse_;
    const Vector zero = complexProduct(constant_, conjugate);
    return {zero, absolute(q_ - zero.x * quadratic_)};
}

HodographFactors::Zero HodographFactors::secondZero() const {
    const Vector conjugate = Vector{quadratic_.x, -quadratic_.y} / slope_ / slope_;
    const Vector zero = complexProduct(q_, conjugate);
    return {zero, slope_ * absolute(firstZero().at - Vector{zero.x, 0})};
}

} // namespace kriva
