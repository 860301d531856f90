#pragma once

#include "ui/document/recovery/recovery_writer.h"

namespace kriva::ui {

/// Keeps the unsaved work of one window on the disk, a running gesture's preview included, so that it outlives a crash
/// or a loss of power. It goes once it is saved, undone, replaced, or the window is closed.
class Recovery : public QObject {
    Q_OBJECT
  public:
    Recovery(const OpenDocument& document, RecoveryWriter& writer, QObject* parent = nullptr);
    ~Recovery() override;

    /// Where the document belongs: an empty path where it has no file yet, and contentHash() of the file.
    void setFile(const QString& path, const QByteArray& hash);
    /// Whether the file does not hold any more what was read from it or written to it: then the window has the only
    /// copy, modified or not.
    void setFileDiffers(bool differs);
    /// Goes on with what was found: the document is that one now.
    void adopt(FoundRecovery found);
    /// Hands over all that is unsaved at once; it stays beyond the end of this object, unless the work goes on.
    void keep();
    [[nodiscard]] bool isKept() const { return isKept_; }

  Q_SIGNALS:
    /// The unsaved work cannot be kept; told once.
    void failed(const kriva::ui::WriteError& error);

  private:
    [[nodiscard]] bool differsFromFile() const { return isModified_ || isFileOther_; }
    [[nodiscard]] bool isUnsaved() const { return differsFromFile() || document_.hasGesture(); }
    void noteChange();
    void follow(bool isModified);
    void record();
    void copyMore();
    void handOver();
    void forget();

    const OpenDocument& document_;
    RecoveryWriter& writer_;
    DocumentShadow shadow_;
    QString id_;
    RecoveryNote about_;
    bool isModified_ = false;
    bool isFileOther_ = false;
    bool hasNews_ = false;    ///< something changed since the last that was handed over
    bool isRecorded_ = false; ///< something is on the disk, or will be
    bool isKept_ = false;
    QTimer quiet_;   ///< since the last change
    QTimer longest_; ///< since the first change that was not handed over
    QTimer copying_;
};

} // namespace kriva::ui
