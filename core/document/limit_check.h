#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"

namespace kriva {

// The errors of these have no place: who edits knows where, who reads a file says it.

/// Why a sheet is beyond the limits that hold over all its curves together; nothing where it is within.
[[nodiscard]] std::optional<FileError> sheetLimitError(const Sheet& sheet);

/// Why a sheet that may well be edited takes too long for a report or a file of its figure; nothing where it does not.
/// This error has a place.
[[nodiscard]] std::optional<FileError> outputLimitError(const Sheet& sheet, SheetIndex index, Output output);

/// Where the curves of a sheet stand in a document: "sheets.spline.curves".
[[nodiscard]] std::string placeOfCurves(SheetIndex sheet);

/// Why a sheet would be beyond the limits of the model with one more curve, or with the curve at `replaced` replaced;
/// nothing where it would be within. Takes the limits of one curve into account as well. Linear in the points.
[[nodiscard]] std::optional<FileError> limitErrorWith(const Sheet& sheet, std::optional<std::size_t> replaced,
                                                      const Curve& curve);

/// "tooManyCurves" for so many, where a sheet takes fewer.
[[nodiscard]] std::optional<FileError> curveCountError(std::size_t curves);

} // namespace kriva
