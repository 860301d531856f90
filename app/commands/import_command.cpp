#include "app/commands/import_command.h"

#include "app/commands/interrupts.h"
#include "app/commands/progress.h"
#include "app/commands/streams.h"
#include "core/io/json/document_json.h"
#include "ui/document/error_text.h"
#include "ui/document/import_text.h"

namespace kriva::app {
namespace {

/// The paths of a file, or the sentence that refuses it.
std::variant<std::vector<ImportedPath>, QString> pathsOf(const QString& file) {
    const auto bytes = readInput(file);
    if (const ui::ReadError* error = std::get_if<ui::ReadError>(&bytes))
        return errorText(*error, file);
    auto read = ui::readImport(std::get<QByteArray>(bytes));
    if (const QString* refusal = std::get_if<QString>(&read))
        return QStringLiteral("%1: %2").arg(file, *refusal);
    return read;
}

} // namespace

ExitCode importFiles(const ImportRequest& request) {
    const Interrupts interrupts;
    Progress progress;
    std::vector<ImportedPath> paths;
    for (qsizetype i = 0; i < request.files.size(); ++i) {
        progress.goOnWith(fileOf(request.files, i));
        auto read = pathsOf(request.files[i]);
        if (const QString* refusal = std::get_if<QString>(&read)) {
            printError(*refusal);
            return ExitCode::refused;
        }
        auto& own = std::get<std::vector<ImportedPath>>(read);
        paths.insert(paths.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    }
    auto curves = importedCurves(paths, request.sheet, request.placing);
    if (const FileError* error = std::get_if<FileError>(&curves)) {
        printError(ui::errorText(ui::OpenError(*error), request.files.join(QStringLiteral(", "))));
        return ExitCode::refused;
    }
    Document document;
    document.active = request.sheet;
    document.sheets[request.sheet].curves = std::get<std::vector<Curve>>(std::move(curves));
    return writeOutput(request.output, QByteArray::fromStdString(writeDocument(document)));
}

} // namespace kriva::app
