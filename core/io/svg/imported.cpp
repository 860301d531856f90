#include "core/io/svg/imported.h"

#include "core/document/limit_check.h"
#include "core/geometry/affine.h"

namespace kriva {

std::variant<std::vector<Curve>, FileError> importedCurves(std::span<const ImportedPath> paths, SheetIndex sheet,
                                                           const Placing& placing) {
    const Affine map = translation(placing.offset) * scaling(placing.scale, placing.scale);
    if (std::optional<FileError> error = curveCountError(paths.size()))
        return std::move(*error);
    Sheet gathered;
    for (const ImportedPath& imported : paths) {
        Path path = imported.path;
        for (Point& p : path.points)
            p = map(p);
        Curve curve = withPathAdded(renamed(emptyCurve(sheet), imported.name), path);
        if (std::optional<FileError> error = limitErrorWith({}, {}, curve)) {
            error->place = imported.name;
            error->curve = static_cast<int>(gathered.curves.size()) + 1;
            return std::move(*error);
        }
        gathered.curves.push_back(std::move(curve));
    }
    if (std::optional<FileError> error = sheetLimitError(gathered))
        return std::move(*error);
    return std::move(gathered.curves);
}

} // namespace kriva
