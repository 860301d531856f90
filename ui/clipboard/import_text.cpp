#include "ui/clipboard/import_text.h"

#include "ui/clipboard/points_table.h"
#include "ui/document/error_text.h"

namespace kriva::ui {

std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text) {
    auto read = readImportedText({text.constData(), static_cast<std::size_t>(text.size())});
    if (const FileError* error = std::get_if<FileError>(&read))
        return errorText(*error);
    if (const TableError* error = std::get_if<TableError>(&read))
        return errorText(*error);
    return std::get<std::vector<ImportedPath>>(std::move(read));
}

} // namespace kriva::ui
