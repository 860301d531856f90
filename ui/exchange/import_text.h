#pragma once

#include "core/io/svg/paths/svg_paths.h"

#include <QByteArray>
#include <QString>

namespace kriva::ui {

/// Whether a text holds paths: an SVG file, or the data of an SVG path. Others are tables.
[[nodiscard]] bool holdsPaths(const QByteArray& text);

/// What can be imported from a file or out of a pasted text: the paths of an SVG file, of path data, or points from a
/// table (readPointsTable); else one line that says why not, and where in the text.
[[nodiscard]] std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text);

} // namespace kriva::ui
