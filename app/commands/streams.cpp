#include "app/commands/streams.h"

#include "app/commands/interrupts.h"
#include "ui/document/document_file.h"
#include "ui/document/error_text.h"
#include "ui/document/file_rights.h"
#include "ui/document/safe_write.h"

#include <QCoreApplication>

namespace kriva::app {
namespace {

class Streams {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString edited(const QString& file) {
        return tr("%1: its lines were edited in another program; the document inside is taken as it was").arg(file);
    }
};

} // namespace

bool isStandardStream(const QString& file) {
    return file == QLatin1Char('-');
}

std::variant<QByteArray, ui::ReadError> readInput(const QString& file) {
    return isStandardStream(file) ? readIn() : ui::boundedRead(file);
}

std::optional<Document> openDocument(const QString& file) {
    auto loaded = ui::documentFrom(readInput(file));
    if (const ui::OpenError* error = std::get_if<ui::OpenError>(&loaded)) {
        printError(errorText(*error, file));
        return {};
    }
    if (std::get<ui::LoadedFile>(loaded).drawn)
        printError(Streams::edited(file));
    return std::get<ui::LoadedFile>(std::move(loaded)).document;
}

ExitCode writeOutput(const QString& file, const QByteArray& bytes) {
    if (isStandardStream(file))
        return printOut(bytes);
    const auto before = ui::rightsOf(file);
    const auto error = [&] {
        const Uninterrupted untilWritten;
        return ui::safeWrite(file, bytes);
    }();
    if (error)
        printError(errorText(*error, file));
    else if (!ui::keptRights(before, file))
        printError(ui::lostRightsText(file));
    return error ? ExitCode::notWritten : ExitCode::done;
}

} // namespace kriva::app
