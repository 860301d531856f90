#include "ui/shell/document_session.h"

#include "ui/document/error_text.h"
#include "ui/shell/examples.h"
#include "ui/shell/preferences.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace kriva::ui {

DocumentSession::DocumentSession(OpenDocument& document, Preferences& preferences, QWidget* window)
    : QObject(window)
    , document_(document)
    , preferences_(preferences)
    , window_(window) {}

QString DocumentSession::name() const {
    return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName();
}

void DocumentSession::newDocument() {
    if (mayClose())
        show({});
}

void DocumentSession::show(Document document) {
    document_.replace(std::move(document));
    setPath({});
}

void DocumentSession::openExample(const QString& resource) {
    if (!mayClose())
        return;
    show(exampleDocument(resource));
    Q_EMIT exampleOpened(resource);
}

void DocumentSession::open() {
    if (!mayClose())
        return;
    const QString path = QFileDialog::getOpenFileName(window_, tr("Open"), QFileInfo(path_).path(),
                                                      tr("Documents and figures of Kriva (*.kriva *.svg)"));
    if (!path.isEmpty())
        openFile(path);
}

bool DocumentSession::openFile(const QString& path) {
    std::variant<LoadedFile, OpenError> loaded = loadDocument(path);
    if (const OpenError* error = std::get_if<OpenError>(&loaded)) {
        tell(tr("The file was not opened"), errorText(*error, path));
        return false;
    }
    std::optional<Document> document = chosen(std::get<LoadedFile>(std::move(loaded)), path);
    if (!document)
        return false;
    document_.replace(std::move(*document));
    // A figure keeps its document inside, but saving must not put a document in the figure's place.
    const bool isDocument = path.endsWith(QLatin1String(".kriva"));
    preferences_.addRecentFile(path);
    setPath(isDocument ? path : QString());
    return true;
}

std::optional<Document> DocumentSession::chosen(LoadedFile loaded, const QString& path) {
    if (!loaded.drawn)
        return std::move(loaded.document);
    QMessageBox box(QMessageBox::Question, tr("An edited figure"),
                    tr("The lines of “%1” were edited in another program: they are not those of the document inside "
                       "any more.")
                        .arg(QFileInfo(path).fileName()),
                    QMessageBox::Cancel, window_);
    box.setInformativeText(tr("Open the document as it was, or as it is drawn now?"));
    const QAbstractButton* const document = box.addButton(tr("&Document"), QMessageBox::AcceptRole);
    QPushButton* const drawing = box.addButton(tr("D&rawing"), QMessageBox::AcceptRole);
    box.setDefaultButton(drawing);
    box.exec();
    if (box.clickedButton() == drawing)
        return std::move(loaded.drawn);
    if (box.clickedButton() == document)
        return std::move(loaded.document);
    return {};
}

bool DocumentSession::save() {
    return path_.isEmpty() ? saveAs() : saveTo(path_);
}

bool DocumentSession::saveAs() {
    QFileDialog dialog(window_, tr("Save as"), QFileInfo(path_).path(), tr("Documents of Kriva (*.kriva)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("kriva"));
    dialog.selectFile(name());
    return dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().constFirst());
}

bool DocumentSession::saveTo(const QString& path) {
    document_.endGesture();
    if (const std::optional<WriteError> error = saveDocument(path, document_.value())) {
        tell(tr("The document was not saved"), errorText(*error, path));
        return false;
    }
    document_.markSaved();
    preferences_.addRecentFile(path);
    setPath(path);
    return true;
}

bool DocumentSession::mayClose() {
    document_.endGesture();
    if (!document_.isModified())
        return true;
    QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"), tr("Save the changes to “%1”?").arg(name()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("Without saving they are lost."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

void DocumentSession::setPath(const QString& path) {
    path_ = path;
    Q_EMIT pathChanged();
}

void DocumentSession::tell(const QString& title, const QString& text) {
    QMessageBox(QMessageBox::Critical, title, text, QMessageBox::Ok, window_).exec();
}

} // namespace kriva::ui
