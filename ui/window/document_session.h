#pragma once

#include "ui/document/document_file.h"
#include "ui/document/recovery/recovery.h"
#include "ui/document/sharing/file_watch.h"
#include "ui/document/sharing/open_files.h"

class QWidget;

namespace kriva::ui {

class Preferences;
enum class SaveAnswer;

/// What the documents of all windows share; it outlives them.
struct SharedFiles {
    explicit SharedFiles(RecoveryTiming timing = {})
        : recovery(timing) {}
    OpenFiles open;
    RecoveryWriter recovery;
};

/// A window's document and its file: new, open, save, and the questions before anything is lost or overwritten.
class DocumentSession : public QObject {
    Q_OBJECT
  public:
    DocumentSession(OpenDocument& document, Preferences& preferences, SharedFiles& shared, QWidget* window);

    /// Empty where the document has no file yet.
    [[nodiscard]] const QString& path() const { return path_; }
    /// The file's name without its folder, or "Untitled" in the present language.
    [[nodiscard]] QString name() const;
    /// How the document's file is on the disk.
    [[nodiscard]] FileWatch& fileWatch() { return watch_; }
    /// Whether no file holds what the window shows: it was changed here, or its file elsewhere.
    [[nodiscard]] bool isUnsaved() const { return document_.isModified() || watch_.state() != FileState::Same; }

    void newDocument();
    /// Asks for a file.
    void open();
    /// Opens the file in place of the present document, once that may go. A file that a window of this program has open
    /// already is shown there.
    void openInstead(const QString& path);
    /// Opens the file in place of the present document, which stays as it was if the file is refused. Where it is a
    /// figure that was edited elsewhere, asks whether to open its document or its drawing.
    bool openFile(const QString& path);
    /// Goes on with unsaved work; what is refused stays where it is.
    bool recover(FoundRecovery found);
    /// Shows an example of the program's own resources, as a document without a file.
    void openExample(const QString& resource);
    /// Puts a document without a file in place of the present one.
    void show(Document document);
    bool save();
    bool saveAs();
    /// Writes to this file, which is the document's own from then on. Asks before what somebody else wrote there or has
    /// open is overwritten.
    bool saveTo(const QString& path);
    /// The document as it is in its file now; asks where changes made here would be lost.
    bool reload();
    /// Asks whether what is in no file should be saved, where there is any; false means: go on as before.
    [[nodiscard]] bool mayClose();
    /// The program is about to be ended from outside: unsaved work is kept for the next start, and nobody is asked.
    void keepForNextStart();

  Q_SIGNALS:
    void pathChanged();
    void unsavedChanged();
    void exampleOpened(const QString& resource);
    /// A sentence for the status row.
    void told(const QString& sentence);

  private:
    using Claim = std::unique_ptr<OpenFiles::Claim>;
    struct File {
        QString path;
        QByteArray hash; ///< of what is in it
        Claim claim;
    };
    /// Nothing where it is somebody else's.
    [[nodiscard]] Claim claim(const QString& path);
    [[nodiscard]] Claim claimBeside(const QString& path) { return shared_.open.claimBeside(path, this); }
    /// Asks where somebody else wrote into the file or has it open.
    [[nodiscard]] SaveAnswer askBeforeWriting(const QString& path);
    /// Asks where no file holds what the window shows.
    [[nodiscard]] SaveAnswer askBeforeClosing();
    /// Whether the document was saved, or is to be lost.
    bool follow(SaveAnswer answer, const QString& path);
    /// What is being typed and dragged belongs to the document from now on.
    void endEdits();
    bool write(const QString& path);
    void setFile(File file);
    void bringUp() const;

    OpenDocument& document_;
    Preferences& preferences_;
    SharedFiles& shared_;
    QWidget* window_;
    QString path_;
    Claim claim_;
    FileWatch watch_;
    Recovery recovery_;
};

} // namespace kriva::ui
