#pragma once

#include "ui/document/document_file.h"
#include "ui/document/open_document.h"

#include <QStringList>

class QWidget;

namespace kriva::ui {

class Preferences;

/// A window's document and its file: new, open, save, and the question before changes are lost.
class DocumentSession : public QObject {
    Q_OBJECT
  public:
    DocumentSession(OpenDocument& document, Preferences& preferences, QWidget* window);

    /// Empty where the document has no file yet.
    [[nodiscard]] const QString& path() const { return path_; }
    /// The file's name without its folder, or "Untitled" in the present language.
    [[nodiscard]] QString name() const;

    void newDocument();
    /// Asks for a file.
    void open();
    /// Opens the file in place of the present document, which stays as it was if the file is refused. Where it is a
    /// figure that was edited elsewhere, asks whether to open its document or its drawing.
    bool openFile(const QString& path);
    /// Shows an example of the program's own resources, as a document without a file.
    void openExample(const QString& resource);
    /// Puts a document without a file in place of the present one.
    void show(Document document);
    bool save();
    bool saveAs();
    /// Writes to this file, which is the document's own from then on.
    bool saveTo(const QString& path);
    /// Asks whether unsaved changes should be saved, where there are any; false means: go on as before.
    [[nodiscard]] bool mayClose();

  Q_SIGNALS:
    void pathChanged();
    void exampleOpened(const QString& resource);

  private:
    /// Nothing where a person wants neither the document nor the drawing.
    std::optional<Document> chosen(LoadedFile loaded, const QString& path);
    void setPath(const QString& path);
    void tell(const QString& title, const QString& text);

    OpenDocument& document_;
    Preferences& preferences_;
    QWidget* window_;
    QString path_;
};

} // namespace kriva::ui
