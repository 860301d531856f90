#pragma once

#include "core/geometry/point.h"

#include <cstdint>

/// Random curves that programs in other languages make bit for bit alike, so that their numbers can be compared.
namespace kriva::test {

/// Source: Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed)
        : state_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    Vector inSquare(double low, double high) {
        const double x = between(low, high);
        return {x, between(low, high)};
    }

  private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

/// Points anywhere in a square of side 1000. The data set `points` has the seed 46.
inline Points randomPoints(std::uint64_t seed, std::size_t count) {
    SplitMix random(seed);
    Points points(count);
    for (Point& p : points)
        p = Point{} + random.inSquare(0, 1000);
    return points;
}

/// The data set `cubics`: a thousand cubics anywhere in the square.
inline std::vector<Points> randomCubics() {
    const Points points = randomPoints(42, 4000);
    std::vector<Points> cubics;
    for (auto p = points.begin(); p != points.end(); p += 4)
        cubics.emplace_back(p, p + 4);
    return cubics;
}

/// The data set `cusps`: a thousand cubics that stand still at a random parameter, the second point of each then moved
/// by up to 1e-3.
inline std::vector<Points> nearCusps() {
    SplitMix random(43);
    std::vector<Points> cubics(1000);
    for (Points& cubic : cubics) {
        const double t = random.between(.2, .8);
        const double u = 1 - t;
        const Point start = Point{} + random.inSquare(0, 1000);
        const Vector first = random.inSquare(-300, 300);
        const Vector last = random.inSquare(-300, 300);
        const Vector middle = -(u * u * first + t * t * last) / (2 * t * u);
        const Point second = start + first;
        const Point third = second + middle;
        cubic = {start, second + random.inSquare(-1e-3, 1e-3), third, third + last};
    }
    return cubics;
}

/// The data set `walk`: from the middle of the square in steps of up to 10 in x and y, mirrored at its sides.
inline Points randomWalk(std::size_t count) {
    const auto bounced = [](double x) { return x < 0 ? -x : x > 1000 ? 2000 - x : x; };
    SplitMix random(47);
    Points points(count);
    Point at{500, 500};
    for (Point& p : points) {
        p = at;
        const Point next = at + random.inSquare(-10, 10);
        at = {bounced(next.x), bounced(next.y)};
    }
    return points;
}

/// The cubics of the uniform Catmull-Rom spline through two points or more; its tangents at the ends are one-sided.
inline std::vector<Points> catmullRom(std::span<const Point> points) {
    const std::size_t last = points.size() - 1;
    const auto tangent = [&](std::size_t i) {
        if (i == 0 || i == last)
            return i == 0 ? points[1] - points[0] : points[last] - points[last - 1];
        return (points[i + 1] - points[i - 1]) / 2;
    };
    std::vector<Points> cubics;
    for (std::size_t i = 0; i < last; ++i)
        cubics.push_back({points[i], points[i] + tangent(i) / 3, points[i + 1] - tangent(i + 1) / 3, points[i + 1]});
    return cubics;
}

} // namespace kriva::test
