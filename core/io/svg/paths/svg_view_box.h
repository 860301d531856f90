#pragma once

#include "core/geometry/affine.h"
#include "core/io/svg/paths/svg_shapes.h"

namespace kriva {

/// "0 0 100 50"
struct ViewBox {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
};

/// Nothing where the text is none, or has no size.
[[nodiscard]] std::optional<ViewBox> readViewBox(std::string_view text);

/// The box into a viewport at the origin (SVG 1.1, 7.8): stretched, or as large as it fits and in the middle. Other
/// ways of preserveAspectRatio are rare and move the picture as a whole.
[[nodiscard]] Affine mapInto(const SvgViewport& size, const ViewBox& box, bool isStretched);

} // namespace kriva
