#include "core/io/imported_text.h"

#include "core/io/open.h"

#include <algorithm>
#include <utility>

namespace kriva {
namespace {

std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

using Imported = std::variant<std::vector<ImportedPath>, FileError, TableError>;

Imported readTable(std::string_view text) {
    auto read = readPointsTable(text);
    if (TableError* error = std::get_if<TableError>(&read))
        return std::move(*error);
    std::vector<ImportedPath> imported;
    for (Points& points : std::get<std::vector<Points>>(read))
        imported.push_back({{}, {std::move(points), {}, false}, {}});
    return imported;
}

} // namespace

bool holdsPaths(std::string_view text) {
    text = withoutMark(text);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\n\v\f\r"), text.size()));
    return isXml(text) || text.starts_with('M') || text.starts_with('m');
}

Imported readImportedText(std::string_view text) {
    text = withoutMark(text);
    if (!holdsPaths(text))
        return readTable(text);
    auto read = isXml(text) ? readSvgPaths(text) : readPathsOfData(text);
    return std::visit([](auto& either) -> Imported { return std::move(either); }, read);
}

} // namespace kriva
