#pragma once

#include "core/document/document.h"
#include "core/io/svg/paths/svg_paths.h"

namespace kriva {

/// Where imported paths go: first scaled from the origin, then moved.
struct Placing {
    double scale = 1;
    Vector offset;
    friend constexpr bool operator==(const Placing&, const Placing&) = default;
};

/// A curve of the sheet's kind for each path, with its name. Refused beyond the limits of the model: of a curve, with
/// its number and its name, or of the sheet.
[[nodiscard]] std::variant<std::vector<Curve>, FileError> importedCurves(std::span<const ImportedPath> paths,
                                                                         SheetIndex sheet, const Placing& placing = {});

} // namespace kriva
