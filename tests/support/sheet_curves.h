#pragma once

#include "core/document/curve.h"

#include <initializer_list>
#include <vector>

namespace kriva::test {

/// A curve of any sheet as tests write it: one of any kind, without the words Curve(...).
struct AnyCurve : Curve {
    AnyCurve(Curve curve)
        : Curve(std::move(curve)) {}
    template <class C>
    requires kIsAmong<C, CurveKinds> AnyCurve(C curve)
        : Curve(std::move(curve)) {}
};

// The sheets by name, wherever they stand among the others.
inline constexpr SheetIndex kElevation = kSheetOf<ElevationCurve>;
inline constexpr SheetIndex kSubdivision = kSheetOf<SubdivisionCurve>;
inline constexpr SheetIndex kSpline = kSheetOf<SplineCurve>;
inline constexpr SheetIndex kCombined = kSheetOf<CombinedCurve>;

/// The curves of a sheet.
inline std::vector<Curve> curves(std::initializer_list<AnyCurve> some) {
    return {some.begin(), some.end()};
}

} // namespace kriva::test
