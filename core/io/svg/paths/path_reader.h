#pragma once

#include "core/curve/file_error.h"
#include "core/figure/figure.h"

#include <variant>

namespace kriva {

/// The subpaths of an SVG path's `d`, in its own coordinates with y down: all commands, absolute and relative; arcs
/// as cubics within kArcTolerance. What draws nothing is left out. Refused with the line and column of the first fault
/// where it breaks the grammar of SVG 1.1 (8.3.9), or has more pieces than a sheet has points. Linear.
[[nodiscard]] std::variant<std::vector<Path>, FileError> readPathData(std::string_view data);

} // namespace kriva
