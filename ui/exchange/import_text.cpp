#include "ui/exchange/import_text.h"

#include "core/io/open.h"
#include "ui/document/error_text.h"
#include "ui/exchange/points_table.h"

namespace kriva::ui {
namespace {

std::string_view viewOf(const QByteArray& text) {
    return {text.constData(), static_cast<std::size_t>(text.size())};
}

std::variant<std::vector<ImportedPath>, QString> readTable(const QString& text) {
    auto read = readPointsTable(text);
    if (const TableError* error = std::get_if<TableError>(&read))
        return errorText(*error);
    std::vector<ImportedPath> imported;
    for (Points& points : std::get<std::vector<Points>>(read))
        imported.push_back({{}, {std::move(points), {}, false}, {}});
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
    return isXml(viewOf(trimmed)) || trimmed.startsWith('M') || trimmed.startsWith('m');
}

std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text) {
    const QByteArray bare = withoutMark(text);
    if (!holdsPaths(bare))
        return readTable(QString::fromUtf8(bare));
    auto read = isXml(viewOf(bare)) ? readSvgPaths(viewOf(bare)) : readPathsOfData(viewOf(bare));
    if (const FileError* error = std::get_if<FileError>(&read))
        return errorText(*error);
    return std::get<std::vector<ImportedPath>>(std::move(read));
}

} // namespace kriva::ui
