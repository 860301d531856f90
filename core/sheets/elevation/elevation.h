#pragma once

#include "core/curve/capabilities.h"
#include "core/figure/caption.h"
#include "core/figure/style/style.h"
#include "core/geometry/point.h"

#include <string>
#include <string_view>

namespace kriva {

/// A Bézier curve and how often its degree is raised.
struct ElevationCurve {
    static constexpr std::string_view kSheet = "elevation";
    static constexpr Caption kCaption = Caption::elevation;
    static constexpr Capabilities kCapabilities{.animation = true};

    std::string name;
    Points points;
    int times = 0;
    CurveStyle style;
    CurveView view;
    friend bool operator==(const ElevationCurve&, const ElevationCurve&) = default;
};

/// Still being drawn: fewer points than a curve needs.
[[nodiscard]] inline bool isIncomplete(const ElevationCurve& curve) {
    return curve.points.size() < 2;
}

/// The same curve with its degree raised.
struct Elevation {
    Points polygon; ///< of degree n + times
    double gap = 0; ///< largest |b_i - B(i/N)|, in document units
};

/// The curve must be complete. O(n (n + times)).
[[nodiscard]] Elevation elevate(const ElevationCurve& curve);

} // namespace kriva
