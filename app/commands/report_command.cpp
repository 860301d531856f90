#include "app/commands/report_command.h"

#include "app/commands/interrupts.h"
#include "app/commands/progress.h"
#include "app/commands/streams.h"
#include "core/document/report.h"
#include "ui/base/language/plain_text.h"
#include "ui/document/error_text.h"
#include "ui/figures/caption_text.h"
#include "ui/panels/result_text.h"

#include <QFileInfo>

#include <algorithm>

namespace kriva::app {
namespace {

/// Enough for people; the JSON has them all.
constexpr int kDigits = 10;

QString curveTitle(const Curve& curve, std::size_t index) {
    QString title = QStringLiteral("%1 %2").arg(ui::captionText(Caption::curve)).arg(index);
    if (!nameOf(curve).empty())
        title += QStringLiteral(": ") + ui::printable(QString::fromStdString(nameOf(curve)));
    return title;
}

/// Rows of two columns, the second one straight below itself.
QString table(const std::vector<Result>& results) {
    qsizetype width = 0;
    for (const Result& result : results)
        width = std::max(width, ui::resultName(result).size());
    QString text;
    for (const Result& result : results) {
        const QString name = ui::resultName(result).leftJustified(width);
        text += QStringLiteral("    %1  %2\n").arg(name, ui::resultValue(result, kDigits));
    }
    return text;
}

std::variant<QString, FileError> sheetTable(const Sheet& sheet, SheetIndex index) {
    const Relations relations = relationsOf(sheet, index);
    if (relations.refusal)
        return *relations.refusal;
    QString text = ui::captionText(captionOf(index)) + QLatin1Char('\n');
    for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
        const Curve& curve = sheet.curves[i];
        text += QStringLiteral("  %1\n").arg(curveTitle(curve, i));
        text += isIncomplete(curve) ? QStringLiteral("    %1\n").arg(ui::captionText(Caption::incomplete))
                                    : table(results(curve));
    }
    return text + table(relations.results);
}

} // namespace

std::variant<QString, FileError> reportTable(const Document& document, std::optional<SheetIndex> only) {
    QStringList parts;
    if (!document.title.empty())
        parts += ui::printable(QString::fromStdString(document.title)) + QLatin1Char('\n');
    for (SheetIndex index = 0; index < kSheetCount; ++index) {
        if (only.value_or(index) != index || document.sheets[index].curves.empty())
            continue;
        const auto part = sheetTable(document.sheets[index], index);
        if (const FileError* error = std::get_if<FileError>(&part))
            return *error;
        parts += std::get<QString>(part);
    }
    return parts.join(QLatin1Char('\n'));
}

ExitCode report(const ReportRequest& request) {
    const Interrupts interrupts;
    const Progress progress(request.file);
    const std::optional<Document> document = openDocument(request.file);
    if (!document)
        return ExitCode::refused;
    const auto refuse = [&](const FileError& error) {
        printError(errorText(ui::OpenError(error), request.file));
        return ExitCode::refused;
    };
    if (const std::optional<FileError> error = reportLimitError(*document, request.sheet))
        return refuse(*error);
    if (!request.isJson) {
        const auto text = reportTable(*document, request.sheet);
        const FileError* error = std::get_if<FileError>(&text);
        return error ? refuse(*error) : printOut(std::get<QString>(text).toUtf8());
    }
    const std::string name = QFileInfo(request.file).fileName().toStdString();
    const auto json = reportJson(*document, name, request.sheet);
    if (const FileError* error = std::get_if<FileError>(&json))
        return refuse(*error);
    const std::string& text = std::get<std::string>(json);
    return printOut(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()))); // may be large
}

} // namespace kriva::app
