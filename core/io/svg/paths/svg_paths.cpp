#include "core/io/svg/paths/svg_paths.h"

#include "core/io/svg/paths/path_reader.h"
#include "core/io/svg/paths/svg_walk.h"

#include <utility>

namespace kriva {
namespace {

/// What `read` makes of the text, where it is XML.
template <class Read>
std::variant<std::vector<ImportedPath>, FileError> inSvg(std::string_view svg, Read read) {
    ParsedSvg parsed;
    if (std::optional<FileError> error = openSvg(svg, parsed))
        return std::move(*error);
    return read(SvgWalk(parsed));
}

} // namespace

std::variant<std::vector<ImportedPath>, FileError> readSvgPaths(std::string_view svg) {
    return inSvg(svg, [](SvgWalk walk) { return std::move(walk).read(); });
}

std::variant<std::vector<ImportedPath>, FileError> readOwnCurves(std::string_view svg) {
    return inSvg(svg, [](SvgWalk walk) { return std::move(walk).readOwn(); });
}

std::variant<std::vector<ImportedPath>, FileError> readPathsOfData(std::string_view data) {
    auto read = readPathData(data);
    if (FileError* error = std::get_if<FileError>(&read))
        return std::move(*error);
    std::vector<ImportedPath> imported;
    for (Path& path : std::get<std::vector<Path>>(read)) {
        for (Point& p : path.points)
            p.y = -p.y; // it goes down in SVG
        imported.push_back({{}, std::move(path), {}});
    }
    if (imported.empty())
        return errorOfFile(FileProblem::noPaths);
    return imported;
}

} // namespace kriva
