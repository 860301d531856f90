#pragma once

#include "core/sheets/subdivision/subdivision.h"
#include "tests/support/any_curve.h"

#include <rapidcheck.h>

namespace kriva::test {

/// Of each point a multiplicity from 1 to 3, t = k/64 and few levels; with a blossom, its arguments are multiples of
/// 1/64 from [-1, 2].
inline rc::Gen<SubdivisionCurve> anySubdivision(int mostPoints = 6) {
    return rc::gen::exec([mostPoints] {
        SubdivisionCurve curve;
        curve.points = *anyCurve(1, mostPoints - 1);
        curve.multiplicity = *rc::gen::container<std::vector<int>>(curve.points.size(), rc::gen::inRange(1, 4));
        curve.t = *rc::gen::inRange(1, 64) / 64.0;
        curve.levels = *rc::gen::inRange(0, 5);
        if (*rc::gen::arbitrary<bool>()) {
            const auto argument = rc::gen::map(rc::gen::inRange(-64, 129), [](int i) { return i / 64.0; });
            curve.blossom = *rc::gen::container<std::vector<double>>(controlPointCount(curve) - 1, argument);
        }
        return curve;
    });
}

/// Whether all counts fit each other, as every edit promises.
inline bool hasValidCounts(const SubdivisionCurve& curve) {
    const std::size_t controlPoints = controlPointCount(curve);
    return curve.multiplicity.size() == curve.points.size() &&
           (!curve.blossom || curve.blossom->size() == std::max<std::size_t>(controlPoints, 1) - 1);
}

} // namespace kriva::test
