#pragma once

#include "core/curve/file_error.h"
#include "core/figure/figure.h"

#include <string>
#include <variant>

namespace kriva {

/// A path out of a file, in document coordinates.
struct ImportedPath {
    std::string name; ///< what a person called it or its group; empty where nobody did
    Path path;
    std::string id = {}; ///< of its element
    friend bool operator==(const ImportedPath&, const ImportedPath&) = default;
};

/// Everything that an SVG file draws as lines, one path for each subpath, in the order of drawing: paths with all
/// their commands, the basic shapes, `use` and nested viewports, with all transforms done. Coordinates are user units
/// of the outermost `svg`, with y up. What is not displayed is left out. Style sheets and clips are not looked at. Of a
/// figure of Kriva's own, its curves alone are taken, without polygons, marks and paper.
/// Refused where a shape cannot be read, at the line of its element, beyond the limits of sheets and of XML, and where
/// nothing is drawn. Linear in what is drawn.
[[nodiscard]] std::variant<std::vector<ImportedPath>, FileError> readSvgPaths(std::string_view svg);

/// The same of the layer with the curves of a figure of Kriva's own; none where there is no such layer.
[[nodiscard]] std::variant<std::vector<ImportedPath>, FileError> readOwnCurves(std::string_view svg);

/// The same of the data of an SVG path alone, as readPathData() reads it.
[[nodiscard]] std::variant<std::vector<ImportedPath>, FileError> readPathsOfData(std::string_view data);

} // namespace kriva
