#pragma once

#include "core/curve/capabilities.h"
#include "core/figure/caption.h"
#include "core/figure/style/style.h"
#include "core/geometry/point.h"

#include <map>
#include <string>
#include <string_view>

/// A curve of arbitrary form through or near given points: polynomials y(x) on monotone runs, joined by Bézier curves.
/// Source: Rossinsky, Kravchenko, Combined algorithm for constructing curves of arbitrary form (2014).
namespace kriva {

namespace limits {
inline constexpr int kFitDegreeLow = 1;
inline constexpr int kFitDegreeHigh = 9;
} // namespace limits

struct CombinedCurve {
    static constexpr std::string_view kSheet = "combined";
    static constexpr Caption kCaption = translatable("Caption", "Combined algorithm");
    static constexpr Capabilities kCapabilities{.animation = true, .longDrawing = true, .outputLimits = true};
    enum class Method { approximation, interpolation, pairs };
    enum class Basis { power, newton, lagrange, chebyshev };

    std::string name;
    Points points; ///< in drawing order
    Method method = Method::approximation;
    int degree = 3; ///< of the approximation, 1 to 9
    Basis basis = Basis::power;
    std::map<int, Point> corrections; ///< middle points of pairs, by the pair's first point; used by Method::pairs
    CurveStyle style;
    CurveView view;
    friend bool operator==(const CombinedCurve&, const CombinedCurve&) = default;
};

/// Without a point there is nothing to draw yet.
[[nodiscard]] inline bool isIncomplete(const CombinedCurve& curve) {
    return curve.points.empty();
}

} // namespace kriva
