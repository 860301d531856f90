#include "app/commands/terminal.h"

#include "app/commands/progress.h"
#include "ui/base/language/plain_text.h"

#include <QCoreApplication>
#include <QFile>

#include <cstdio>
#include <cstdlib>

namespace kriva::app {
namespace {

class Terminal {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString notWritten() { return tr("the output could not be written"); }
};

/// The sentence of endWithoutDisplay(): a message handler can be given nothing.
QString sentenceWithoutDisplay; // NOLINT(cert-err58-cpp): an empty QString allocates nothing

bool writeAll(const QByteArray& bytes, std::FILE* stream) {
    const auto size = static_cast<std::size_t>(bytes.size());
    return std::fwrite(bytes.constData(), 1, size, stream) == size && std::fflush(stream) == 0;
}

void logMessage(QtMsgType, const QMessageLogContext&, const QString& message) {
    printError(message);
}

void endOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type != QtFatalMsg)
        return;
    printError(sentenceWithoutDisplay);
    std::_Exit(static_cast<int>(ExitCode::failure));
}

} // namespace

void printError(const QString& line) {
    constexpr qsizetype kLongestLine = 1000;
    const QString whole = QStringLiteral("kriva: ") + ui::printable(line);
    const QString cut = whole.size() > kLongestLine ? whole.first(kLongestLine - 1) + QChar(u'…') : whole;
    eraseProgress();
    // Where stderr itself is gone there is nobody left to tell.
    (void)writeAll(cut.toUtf8() + '\n', stderr);
}

std::variant<QByteArray, ui::ReadError> readIn() {
    QFile in;
    if (!in.open(stdin, QIODevice::ReadOnly))
        return ui::ReadError{ui::ReadFault::Failed};
    QByteArray bytes;
    while (bytes.size() <= ui::kLargestFile) {
        const QByteArray more = in.read(ui::kLargestFile + 1 - bytes.size());
        if (more.isEmpty())
            break;
        bytes += more;
    }
    if (in.error() != QFile::NoError)
        return ui::ReadError{ui::ReadFault::Failed};
    if (bytes.size() > ui::kLargestFile)
        return ui::ReadError{ui::ReadFault::TooLarge};
    return bytes;
}

ExitCode printOut(const QByteArray& bytes) {
    endProgress();
    if (writeAll(bytes, stdout))
        return ExitCode::done;
    printError(Terminal::notWritten());
    return ExitCode::notWritten;
}

void logToTerminal() {
    qInstallMessageHandler(logMessage);
}

void endWithoutDisplay(const QString& sentence) {
    sentenceWithoutDisplay = sentence;
    qInstallMessageHandler(endOnFatal);
}

} // namespace kriva::app
