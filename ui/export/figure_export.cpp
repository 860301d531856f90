#include "ui/export/figure_export.h"

#include "core/curve/limits.h"
#include "core/io/svg/curve_svg.h"
#include "ui/base/message_box.h"
#include "ui/document/error_text.h"
#include "ui/document/file_rights.h"
#include "ui/editing/sheet_editor.h"
#include "ui/export/export_dialog.h"
#include "ui/export/long_work.h"
#include "ui/figures/caption_text.h"
#include "ui/figures/print_drawing.h"

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMimeData>
#include <QPrinter>
#include <QPrintPreviewDialog>

#include <array>
#include <memory>
#include <utility>

namespace kriva::ui {
namespace {

void tellFailure(const QString& sentence, QWidget* window) {
    showError({FigureExport::tr("The figure was not written"), sentence, {}}, window);
}

/// Whether the file is there now; what went wrong is told.
bool writeOrTell(const FigureFile& made, const QString& path, QWidget* window) {
    if (!std::holds_alternative<QByteArray>(made)) {
        tellFailure(QStringLiteral("%1: %2").arg(path, faultText(made)), window);
        return false;
    }
    const auto error = safeWrite(path, std::get<QByteArray>(made));
    if (error)
        tellFailure(errorText(*error, path), window);
    return !error;
}

/// A file for a format; nothing where the person thought better of it.
std::optional<QString> askForFile(const QString& proposed, const QStringList& filters, QWidget* window) {
    QFileDialog dialog(window, FigureExport::tr("Export figure"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    dialog.setDefaultSuffix(QFileInfo(proposed).suffix());
    dialog.selectFile(proposed);
    if (dialog.exec() != QDialog::Accepted)
        return {};
    return dialog.selectedFiles().constFirst();
}

QString filterFor(FigureFormat format) {
    const QString files = QStringLiteral("*%1").arg(suffixOf(format));
    return FigureExport::tr("Figures (%1)").arg(files);
}

/// "name-elevation.svg"
QString proposedName(const SheetEditor& editor, const QString& name, FigureFormat format) {
    return QStringLiteral("%1-%2%3").arg(QFileInfo(name).completeBaseName(),
                                         QString::fromUtf8(sheetName(editor.index())), suffixOf(format));
}

/// The file of the stage on view; nothing where a person would not wait for it.
std::optional<FigureFile> madeFile(const SheetEditor& editor, FigureFileOptions options, QWidget* window) {
    options.drawing.stage = editor.layerStage();
    return workedOut<FigureFile>(
        [document = editor.documentOnView(), sheet = editor.index(), options](const std::stop_token& stop) {
            WorkBudget budget(limits::kSteps, stop);
            return figureFile(document, sheet, options, budget);
        },
        FigureExport::tr("Working out the figure…"), window);
}

FigureFileOptions optionsOf(const SheetEditor& editor) {
    return editor.sheet().view.exported.value_or(FigureFileOptions());
}

} // namespace

void exportPlots(const std::vector<Plot>& plots, FigureFileOptions& options, QThreadPool& workers, QWidget* window) {
    ExportDialog dialog(plotsToExport(plots), options, workers, window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    options = dialog.options();
    const QString proposed = QStringLiteral("plot%1").arg(suffixOf(options.format));
    const std::optional<QString> path = askForFile(proposed, {filterFor(options.format)}, window);
    if (!path)
        return;
    options.format = figureFormatOf(*path).value_or(options.format);
    writeOrTell(drawingFile(drawingOf(plots, textSource(), options.drawing), options), *path, window);
}

FigureExport::FigureExport(QWidget* window)
    : QObject(window)
    , window_(window) {}

void FigureExport::ask(const SheetEditor& editor, const QString& name) {
    ExportDialog dialog(sheetToExport(editor.documentOnView(), editor.index(), editor.layerStage()), optionsOf(editor),
                        editor.workers(), window_);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const FigureFormat format = dialog.options().format;
    editor.document().setExported(editor.index(), dialog.options());
    if (const std::optional<QString> path =
            askForFile(proposedName(editor, name, format), {filterFor(format)}, window_))
        write(editor, *path);
}

void FigureExport::again(const SheetEditor& editor, const QString& name) {
    const QString path = paths_[editor.index()]; // write() sets it
    if (path.isEmpty())
        ask(editor, name);
    else
        write(editor, path);
}

void FigureExport::write(const SheetEditor& editor, const QString& path) {
    FigureFileOptions options = optionsOf(editor);
    // What is called .pdf is one, whatever was chosen before.
    options.format = figureFormatOf(path).value_or(options.format);
    editor.document().setExported(editor.index(), options);
    const std::optional<FileRights> before = rightsOf(path);
    const std::optional<FigureFile> made = madeFile(editor, options, window_);
    if (!made || !writeOrTell(*made, path, window_))
        return;
    paths_[editor.index()] = path;
    Q_EMIT told(keptRights(before, path) ? tr("Written: %1").arg(path) : lostRightsText(path));
}

void FigureExport::copy(const SheetEditor& editor) const {
    constexpr std::array<std::pair<FigureFormat, const char*>, 3> kTypes{{{FigureFormat::svg, "image/svg+xml"},
                                                                          {FigureFormat::pdf, "application/pdf"},
                                                                          {FigureFormat::png, "image/png"}}};
    auto clip = std::make_unique<QMimeData>();
    FigureFileOptions options = optionsOf(editor);
    for (const auto& [format, type] : kTypes) {
        options.format = format;
        const std::optional<FigureFile> made = madeFile(editor, options, window_);
        if (!made)
            return;
        if (std::holds_alternative<FileError>(*made)) // none of the others is there either
            return tellFailure(faultText(*made), window_);
        if (const QByteArray* bytes = std::get_if<QByteArray>(&*made))
            clip->setData(QLatin1String(type), *bytes);
    }
    QGuiApplication::clipboard()->setMimeData(clip.release());
}

void FigureExport::copyTikz(const SheetEditor& editor) const {
    FigureFileOptions options = optionsOf(editor);
    options.format = FigureFormat::tikz;
    options.tikz = TikzKind::fragment;
    const std::optional<FigureFile> made = madeFile(editor, options, window_);
    if (!made)
        return;
    if (const QByteArray* text = std::get_if<QByteArray>(&*made))
        QGuiApplication::clipboard()->setText(QString::fromUtf8(*text));
    else
        tellFailure(faultText(*made), window_);
}

void FigureExport::copyPath(const SheetEditor& editor) const {
    const Curve* curve = editor.activeCurve();
    const std::optional<std::string> data = curve ? writeCurvePathData(*curve) : std::nullopt;
    if (data)
        QGuiApplication::clipboard()->setText(QString::fromStdString(*data));
}

void FigureExport::print(const SheetEditor& editor, const QString& name) {
    DrawingOptions options = optionsOf(editor).drawing;
    options.stage = editor.layerStage();
    const auto made = workedOut<Drawing>(
        [document = editor.documentOnView(), sheet = editor.index(), options](const std::stop_token& stop) {
            WorkBudget budget(limits::kSteps, stop);
            return drawingOf(document, sheet, textSource(), options, budget);
        },
        tr("Working out the figure…"), window_);
    if (!made)
        return;
    if (made->refusal)
        return tellFailure(errorText(*made->refusal), window_);
    const Drawing& drawing = *made;
    QPrinter printer(QPrinter::HighResolution);
    printer.setDocName(name);
    printer.setPageOrientation(drawing.page.width > drawing.page.height ? QPageLayout::Landscape
                                                                        : QPageLayout::Portrait);
    QPrintPreviewDialog preview(&printer, window_);
    preview.setWindowTitle(tr("Print"));
    connect(&preview, &QPrintPreviewDialog::paintRequested, this,
            [&drawing](QPrinter* paper) { printDrawing(*paper, drawing, textSource()); });
    preview.exec();
}

void FigureExport::forgetFiles() {
    paths_.fill({});
}

} // namespace kriva::ui
