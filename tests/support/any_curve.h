#pragma once

#include "core/geometry/point.h"

#include <rapidcheck.h>

namespace kriva::test {

/// A point whose coordinates are multiples of 1/64 between -1000 and 1000.
inline rc::Gen<Point> anyPoint() {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-64000, 64001), [](int i) { return i / 64.0; });
    return rc::gen::map(rc::gen::pair(coordinate, coordinate), [](const std::pair<double, double>& xy) {
        return Point{xy.first, xy.second};
    });
}

/// A curve of a degree between the two given.
inline rc::Gen<Points> anyCurve(int leastDegree, int mostDegree) {
    return rc::gen::mapcat(rc::gen::inRange(leastDegree, mostDegree + 1), [](int degree) {
        return rc::gen::container<Points>(static_cast<std::size_t>(degree) + 1, anyPoint());
    });
}

/// A parameter between 0 and 1, both included.
inline rc::Gen<double> anyParameter() {
    return rc::gen::map(rc::gen::inRange(0, 1001), [](int i) { return i / 1000.0; });
}

} // namespace kriva::test
