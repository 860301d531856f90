#pragma once

#include "core/io/svg/paths/svg_paths.h"
#include "core/io/tables/points_reader.h"

namespace kriva {

/// Whether a text holds paths: an SVG file, or the data of an SVG path. Others are tables. A mark of the byte order,
/// which spreadsheets write, is passed over.
[[nodiscard]] bool holdsPaths(std::string_view text);

/// What can be imported from a file or out of a pasted text: the paths of an SVG file, of path data, or points from a
/// table (readPointsTable()), a path without a name for each curve; else why not, and where in the text.
[[nodiscard]] std::variant<std::vector<ImportedPath>, FileError, TableError> readImportedText(std::string_view text);

} // namespace kriva
