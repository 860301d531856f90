#include "ui/exchange/import_text.h"

#include "core/io/svg/paths/path_reader.h"
#include "ui/document/error_text.h"
#include "ui/exchange/points_table.h"

namespace kriva::ui {
namespace {

using PathsOrFault = std::variant<std::vector<ImportedPath>, FileError>;

bool isSvg(const QByteArray& trimmed) {
    return trimmed.startsWith('<');
}

PathsOrFault readData(std::string_view data) {
    auto read = readPathData(data);
    if (FileError* error = std::get_if<FileError>(&read))
        return std::move(*error);
    std::vector<ImportedPath> imported;
    for (Path& path : std::get<std::vector<Path>>(read)) {
        for (Point& p : path.points)
            p.y = -p.y; // it goes down in SVG
        imported.push_back({{}, std::move(path)});
    }
    if (imported.empty()) {
        FileError error;
        error.problem = FileProblem::noPaths;
        return error;
    }
    return imported;
}

std::variant<std::vector<ImportedPath>, QString> readTable(const QString& text) {
    auto read = readPointsTable(text);
    if (const TableError* error = std::get_if<TableError>(&read))
        return errorText(*error);
    std::vector<ImportedPath> imported;
    for (Points& points : std::get<std::vector<Points>>(read))
        imported.push_back({{}, {std::move(points), {}, false}});
    return imported;
}

/// Spreadsheets write a mark of the byte order.
QByteArray withoutMark(const QByteArray& text) {
    constexpr char kMark[] = "\xEF\xBB\xBF";
    return text.startsWith(kMark) ? text.sliced(3) : text;
}

} // namespace

bool holdsPaths(const QByteArray& text) {
    const QByteArray trimmed = withoutMark(text).trimmed();
    return isSvg(trimmed) || trimmed.startsWith('M') || trimmed.startsWith('m');
}

std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text) {
    const QByteArray bare = withoutMark(text);
    if (!holdsPaths(bare))
        return readTable(QString::fromUtf8(bare));
    const std::string_view bytes(bare.constData(), static_cast<std::size_t>(bare.size()));
    PathsOrFault read = isSvg(bare.trimmed()) ? readSvgPaths(bytes) : readData(bytes);
    if (const FileError* error = std::get_if<FileError>(&read))
        return errorText(*error);
    return std::get<std::vector<ImportedPath>>(std::move(read));
}

} // namespace kriva::ui
