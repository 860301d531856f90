#pragma once

#include "core/document/document.h"
#include "core/figure/text_source.h"

namespace kriva {

/// The curve itself, alone and without paper, as an SVG figure whose path other programs take. Nothing for curves that
/// are not drawn yet. Without a scale, the longer side is that of a page.
[[nodiscard]] std::optional<std::string> writeCurveSvg(const Curve& curve, std::optional<double> mmPerUnit,
                                                       const TextSource& texts);

/// The data of SVG paths that draw the curve itself, in its own units with y down: what can be pasted again. To 1e-13
/// of its largest coordinate; higher degrees as cubics within a billionth of it. Nothing for curves that are not drawn
/// yet.
[[nodiscard]] std::optional<std::string> writeCurvePathData(const Curve& curve);

} // namespace kriva
