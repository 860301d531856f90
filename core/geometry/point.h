#pragma once

#include <cmath>
#include <span>
#include <vector>

/// Points and vectors of the plane. They differ: two points have a difference, not a sum.
namespace kriva {

struct Vector {
    double x = 0;
    double y = 0;
    friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

/// A place in document coordinates: x to the right, y up, abstract units.
struct Point {
    double x = 0;
    double y = 0;
    friend constexpr bool operator==(const Point&, const Point&) = default;
};

using Points = std::vector<Point>;

constexpr Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vector operator-(Vector a) {
    return {-a.x, -a.y};
}
constexpr Vector operator*(double s, Vector a) {
    return {s * a.x, s * a.y};
}
constexpr Vector operator*(Vector a, double s) {
    return s * a;
}
constexpr Vector operator/(Vector a, double s) {
    return {a.x / s, a.y / s};
}
constexpr Vector operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Point operator+(Point a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Point operator-(Point a, Vector b) {
    return {a.x - b.x, a.y - b.y};
}

constexpr double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of a x b: positive where b lies to the left of a.
constexpr double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}
/// Without overflow or underflow on the way.
inline double length(Vector a) {
    return std::hypot(a.x, a.y);
}
inline double distance(Point a, Point b) {
    return length(b - a);
}
/// (1 - t) a + t b: both ends are met exactly at t = 0 and t = 1.
constexpr Point lerp(Point a, Point b, double t) {
    return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}
constexpr Point midpoint(Point a, Point b) {
    return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
}
/// The mirror image of p through the centre.
constexpr Point mirrored(Point p, Point centre) {
    return centre + (centre - p);
}
inline bool isFinite(Point p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}
/// Whether both coordinates are at most `limit` in absolute value; NaN is within none.
inline bool isWithin(Point p, double limit) {
    return std::abs(p.x) <= limit && std::abs(p.y) <= limit;
}
inline bool areWithin(std::span<const Point> points, double limit) {
    for (const Point p : points)
        if (!isWithin(p, limit))
            return false;
    return true;
}

} // namespace kriva
