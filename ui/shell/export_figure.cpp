#include "ui/shell/export_figure.h"

#include "core/io/svg_writer.h"
#include "ui/document/error_text.h"
#include "ui/figures/caption_text.h"
#include "ui/sheets/sheet_editor.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace kriva::ui {
namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(ExportFigure)
};

/// "name-elevation.svg"
QString proposedName(const SheetEditor& editor, const QString& name) {
    const std::string_view sheet = sheetName(editor.index());
    return QStringLiteral("%1-%2.svg")
        .arg(QFileInfo(name).completeBaseName(), QString::fromUtf8(sheet.data(), static_cast<qsizetype>(sheet.size())));
}

/// Asks for a file, proposing a name, and writes into it what `make` gives.
template <class Make>
void askAndWrite(const QString& proposed, QWidget* window, Make make) {
    QFileDialog dialog(window, Texts::tr("Export figure"), QString(), Texts::tr("SVG figures (*.svg)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("svg"));
    dialog.selectFile(proposed);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QString path = dialog.selectedFiles().constFirst();
    const std::string svg = make();
    if (const auto error = safeWrite(path, {svg.data(), static_cast<qsizetype>(svg.size())}))
        QMessageBox(QMessageBox::Critical, Texts::tr("The figure was not written"), errorText(*error, path),
                    QMessageBox::Ok, window)
            .exec();
}

} // namespace

void exportFigure(const SheetEditor& editor, const QString& name, QWidget* window) {
    askAndWrite(proposedName(editor, name), window,
                [&] { return writeSheetSvg(editor.documentOnView(), editor.index(), textSource()); });
}

void exportPlots(const std::vector<Plot>& plots, QWidget* window) {
    askAndWrite(QStringLiteral("plot.svg"), window, [&] { return writePlotsSvg(plots, textSource()); });
}

} // namespace kriva::ui
