#include "app/commands/export_command.h"

#include "core/io/svg_writer.h"
#include "ui/document/document_file.h"
#include "ui/document/error_text.h"
#include "ui/figures/caption_text.h"

#include <QCoreApplication>

namespace kriva::app {
namespace {

class Export {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString nothingToDraw(const QString& file) { return tr("%1: there is no curve to draw").arg(file); }
};

bool isEmpty(const Document& document, SheetIndex sheet) {
    return document.sheets[sheet].curves.empty();
}

/// The sheet to draw: the one asked for, else the active one, else the first that holds a curve.
std::optional<SheetIndex> sheetToDraw(const Document& document, std::optional<SheetIndex> asked) {
    const SheetIndex wanted = asked.value_or(document.active);
    if (!isEmpty(document, wanted))
        return wanted;
    for (SheetIndex sheet = 0; sheet < kSheetCount && !asked; ++sheet)
        if (!isEmpty(document, sheet))
            return sheet;
    return {};
}

} // namespace

ExitCode exportFigure(const ExportRequest& request) {
    const auto loaded = ui::loadDocument(request.file);
    if (const ui::OpenError* error = std::get_if<ui::OpenError>(&loaded)) {
        printError(errorText(*error, request.file));
        return ExitCode::refused;
    }
    const Document& document = std::get<Document>(loaded);
    const std::optional<SheetIndex> sheet = sheetToDraw(document, request.sheet);
    if (!sheet) {
        printError(Export::nothingToDraw(request.file));
        return ExitCode::failure;
    }
    const std::string svg = writeSheetSvg(document, *sheet, ui::textSource());
    if (const auto error = ui::safeWrite(request.output, {svg.data(), static_cast<qsizetype>(svg.size())})) {
        printError(errorText(*error, request.output));
        return ExitCode::notWritten;
    }
    return ExitCode::done;
}

} // namespace kriva::app
