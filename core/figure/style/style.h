#pragma once

#include "core/figure/style/figure_options.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What changes how a figure looks and never a number in the report. The keys on disk are listed in ARCHITECTURE.md.
namespace kriva {

struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend constexpr bool operator==(const Color&, const Color&) = default;
};

enum class LineDash { solid, dashed, dotted, dashDot };

enum class Marker { none, circle, square, diamond, ring };

/// Undone like points; what is not set follows the role's style.
struct CurveStyle {
    std::optional<Color> color;
    std::optional<double> width;  ///< of the curve's line, in points
    std::optional<LineDash> dash; ///< of the curve's line
    std::optional<Marker> marker; ///< of the curve's points; never a ring, which is that of crossings
    bool hasLabels = true;
    friend bool operator==(const CurveStyle&, const CurveStyle&) = default;
};

/// How wide a line may be, in points: thinner than the least no printer draws.
inline constexpr double kLeastWidth = 0.05;
inline constexpr double kMostWidth = 20;

/// Saved, but never undone and never a modification.
struct CurveView {
    bool isShown = true;
    friend bool operator==(const CurveView&, const CurveView&) = default;
};

/// Saved, but never undone and never a modification.
struct SheetView {
    int activeCurve = 0;
    std::map<std::string, bool> layers; ///< by layer name, where it differs from the layer's default
    std::optional<double> mmPerUnit;    ///< scale of the page; by default its longer side is 120 mm
    /// By the name of a ViewSetting, where they differ from the usual: one number, or several.
    std::map<std::string, std::vector<double>, std::less<>> settings;
    std::optional<FigureFileOptions> exported; ///< as its figure was written last
    friend bool operator==(const SheetView&, const SheetView&) = default;
};

} // namespace kriva
