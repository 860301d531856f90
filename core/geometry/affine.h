#pragma once

#include "core/geometry/point.h"

namespace kriva {

/// x' = a x + c y + e, y' = b x + d y + f: the letters of SVG's matrix(a b c d e f).
struct Affine {
    double a = 1;
    double b = 0;
    double c = 0;
    double d = 1;
    double e = 0;
    double f = 0;
    friend constexpr bool operator==(const Affine&, const Affine&) = default;

    [[nodiscard]] constexpr Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
};

[[nodiscard]] constexpr Affine translation(Vector by) {
    return {1, 0, 0, 1, by.x, by.y};
}
[[nodiscard]] constexpr Affine scaling(double x, double y) {
    return {x, 0, 0, y, 0, 0};
}

/// The right one first, then the left one.
[[nodiscard]] constexpr Affine operator*(const Affine& l, const Affine& r) {
    return {l.a * r.a + l.c * r.b, l.b * r.a + l.d * r.b,       l.a * r.c + l.c * r.d,
            l.b * r.c + l.d * r.d, l.a * r.e + l.c * r.f + l.e, l.b * r.e + l.d * r.f + l.f};
}

} // namespace kriva
