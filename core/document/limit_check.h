#pragma once

#include "core/document/document.h"
#include "core/document/file_error.h"

namespace kriva {

/// "tooMany" at the curves of a sheet.
[[nodiscard]] FileError tooManyCurves(SheetIndex sheet, std::size_t limit);

/// Why a sheet is beyond the limits that hold over all its curves together; nothing where it is within.
[[nodiscard]] std::optional<FileError> sheetLimitError(const Sheet& sheet, SheetIndex index);

/// Why a sheet that may well be edited takes too long for a report or a file of its figure; nothing where it does not.
[[nodiscard]] std::optional<FileError> interpolationLimitError(const Sheet& sheet, SheetIndex index);

/// Why a sheet would be beyond the limits of the model with one more curve, or with the curve at `replaced` replaced;
/// nothing where it would be within. Takes the limits of one curve into account as well. Linear in the points.
[[nodiscard]] std::optional<FileError> limitErrorWith(const Sheet& sheet, SheetIndex index,
                                                      std::optional<std::size_t> replaced, const Curve& curve);

} // namespace kriva
