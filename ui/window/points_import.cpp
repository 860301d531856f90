#include "ui/window/points_import.h"

#include "ui/base/message_box.h"
#include "ui/document/bounded_read.h"
#include "ui/document/error_text.h"
#include "ui/document/import_text.h"
#include "ui/editing/sheet_editor.h"
#include "ui/window/dialogs/import_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>

namespace kriva::ui {
namespace {

class PointsImport {
    Q_DECLARE_TR_FUNCTIONS(PointsImport)
  public:
    static QString title() { return tr("Import points"); }
    static QString filters() { return tr("Paths and points (*.svg *.csv *.tsv *.txt);;All files (*)"); }
    static QString failure() { return tr("Nothing was imported"); }
};

} // namespace

bool importPoints(SheetEditor& editor, QWidget* window) {
    editor.document().endGesture();
    const QString path = QFileDialog::getOpenFileName(window, PointsImport::title(), {}, PointsImport::filters());
    if (path.isEmpty())
        return false;
    const auto refuse = [window](const QString& sentence) {
        showError({PointsImport::failure(), sentence, {}}, window);
        return false;
    };
    const auto bytes = boundedRead(path);
    if (const ReadError* error = std::get_if<ReadError>(&bytes))
        return refuse(errorText(OpenError(*error), path));
    auto read = readImport(std::get<QByteArray>(bytes));
    if (const QString* refusal = std::get_if<QString>(&read))
        return refuse(QStringLiteral("%1: %2").arg(path, *refusal));
    ImportDialog dialog(std::get<std::vector<ImportedPath>>(std::move(read)), editor.index(), window);
    if (dialog.exec() != QDialog::Accepted)
        return false;
    return editor.addCurves(dialog.curves(), {QT_TRANSLATE_NOOP("Step", "Import curves")});
}

} // namespace kriva::ui
