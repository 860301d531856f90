#include "app/commands/export_command.h"

#include "app/commands/interrupts.h"
#include "app/commands/progress.h"
#include "app/commands/streams.h"
#include "core/document/limit_check.h"
#include "ui/document/error_text.h"
#include "ui/figures/figure_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace kriva::app {
namespace {

class Export {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString nothingToDraw(const QString& file) { return tr("%1: there is no curve to draw").arg(file); }
    static QString noSuchCurve(const QString& file, std::size_t curve, std::size_t count) {
        return tr("%1: there is no curve %2; the sheet has %3, counted from 0").arg(file).arg(curve).arg(count);
    }
    static QString noSuchLayer(const QString& layer, const QStringList& layers) {
        return tr("there is no layer %1; the sheet has %2").arg(layer, layers.join(QStringLiteral(", ")));
    }
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

QString layerFault(const DrawingOptions& options, SheetIndex sheet) {
    QStringList names;
    for (const LayerInfo& layer : layersOf(sheet))
        names.append(QString::fromUtf8(layer.name));
    for (const std::string& layer : options.layers.value_or(std::vector<std::string>()))
        if (!names.contains(QString::fromStdString(layer)))
            return Export::noSuchLayer(QString::fromStdString(layer), names);
    return {};
}

/// What a name of a file may have whatever the system: other characters become `_`.
QString reducedName(const QString& file) {
    QString name = isStandardStream(file) ? QStringLiteral("figure") : QFileInfo(file).completeBaseName();
    for (QChar& c : name)
        if (!(c.unicode() < 0x80 && (c.isLetterOrNumber() || QStringLiteral("._-").contains(c))))
            c = QLatin1Char('_');
    return name;
}

QString outputFor(QString pattern, const QString& file, SheetIndex sheet) {
    return pattern.replace(QStringLiteral("{name}"), reducedName(file))
        .replace(QStringLiteral("{sheet}"), QString::fromUtf8(sheetName(sheet)));
}

const QString kFrame = QStringLiteral("{frame}");

/// Three digits, so that the files stand in their order.
QString numbered(QString output, std::size_t frame) {
    return output.replace(kFrame, QStringLiteral("%1").arg(frame, 3, 10, QLatin1Char('0')));
}

ExitCode refused(const QString& sentence, ExitCode code) {
    printError(sentence);
    return code;
}

ExitCode exportOne(const QString& file, const ExportRequest& request) {
    const std::optional<Document> document = openDocument(file);
    if (!document)
        return ExitCode::refused;
    const std::optional<SheetIndex> sheet = sheetToDraw(*document, request.sheet);
    if (!sheet)
        return refused(Export::nothingToDraw(file), ExitCode::failure);
    if (const std::optional<FileError> error = outputLimitError(document->sheets[*sheet], *sheet, Output::figure))
        return refused(ui::errorText(ui::OpenError(*error), file), ExitCode::refused);
    const DrawingOptions& drawing = request.options.drawing;
    const std::size_t curves = document->sheets[*sheet].curves.size();
    if (drawing.curve.value_or(0) >= curves)
        return refused(Export::noSuchCurve(file, *drawing.curve, curves), ExitCode::usage);
    if (const QString fault = layerFault(drawing, *sheet); !fault.isEmpty())
        return refused(fault, ExitCode::usage);
    const QString output = outputFor(request.output, file, *sheet);
    const bool isNumbered = output.contains(kFrame) && !request.options.frames.empty();
    WorkBudget budget(limits::kSteps);
    const std::vector<ui::FigureFile> made =
        isNumbered ? ui::frameFiles(*document, *sheet, request.options, budget)
                   : std::vector{ui::figureFile(*document, *sheet, request.options, budget)};
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (!std::holds_alternative<QByteArray>(made[i]))
            return refused(QStringLiteral("%1: %2").arg(file, faultText(made[i])),
                           std::holds_alternative<FileError>(made[i]) ? ExitCode::refused : ExitCode::failure);
        const ExitCode code = writeOutput(numbered(output, i), std::get<QByteArray>(made[i]));
        if (code != ExitCode::done)
            return code;
    }
    return ExitCode::done;
}

} // namespace

ExitCode exportFigures(const ExportRequest& request) {
    const Interrupts interrupts;
    Progress progress;
    ExitCode worst = ExitCode::done;
    for (qsizetype i = 0; i < request.files.size(); ++i) {
        progress.goOnWith(fileOf(request.files, i));
        worst = std::max(worst, exportOne(request.files[i], request));
    }
    return worst;
}

} // namespace kriva::app
