#include "app/commands/streams.h"

#include "ui/document/error_text.h"
#include "ui/document/safe_write.h"

namespace kriva::app {

bool isStandardStream(const QString& file) {
    return file == QLatin1Char('-');
}

std::variant<QByteArray, ui::ReadError> readInput(const QString& file) {
    return isStandardStream(file) ? readIn() : ui::boundedRead(file);
}

ExitCode writeOutput(const QString& file, const QByteArray& bytes) {
    if (isStandardStream(file))
        return printOut(bytes);
    const auto error = ui::safeWrite(file, bytes);
    if (error)
        printError(errorText(*error, file));
    return error ? ExitCode::notWritten : ExitCode::done;
}

} // namespace kriva::app
