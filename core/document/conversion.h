#pragma once

#include "core/document/document.h"

namespace kriva {

/// A curve of another sheet through the same points, each once, in their order, with its name and its style; all else
/// is as in a new curve of that sheet. A curve of the sheet itself stays what it is.
[[nodiscard]] Curve converted(const Curve& curve, SheetIndex sheet);

/// The points of a curve, in their order.
[[nodiscard]] Points pointsOf(const Curve& curve);

} // namespace kriva
