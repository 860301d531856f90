#include "ui/window/document_session.h"

#include "ui/base/examples.h"
#include "ui/base/preferences.h"
#include "ui/controls/typing.h"
#include "ui/document/error_text.h"
#include "ui/document/state_folder.h"
#include "ui/window/asked_document.h"
#include "ui/window/dialogs/document_questions.h"

#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace kriva::ui {

DocumentSession::DocumentSession(OpenDocument& document, Preferences& preferences, SharedFiles& shared, QWidget* window)
    : QObject(window)
    , document_(document)
    , preferences_(preferences)
    , shared_(shared)
    , window_(window)
    , recovery_(document, shared.recovery) {
    connect(&shared.open, &OpenFiles::bringUpAsked, this, [this](const QObject* holder) {
        if (holder == this)
            bringUp();
    });
    connect(&watch_, &FileWatch::changed, this, [this](FileState state) {
        recovery_.setFileDiffers(state != FileState::Same);
        Q_EMIT unsavedChanged();
    });
    connect(&document, &OpenDocument::modifiedChanged, this, &DocumentSession::unsavedChanged);
    connect(&recovery_, &Recovery::failed, this, [this](const WriteError& error) {
        Q_EMIT told(tr("Unsaved changes cannot be kept for a recovery: %1").arg(errorText(error, stateFolder())));
    });
}

QString DocumentSession::name() const {
    return path_.isEmpty() ? tr("Untitled") : QFileInfo(path_).fileName();
}

void DocumentSession::newDocument() {
    if (!mayClose())
        return;
    Document empty;
    empty.active = document_.value().active; // a person stays where they are
    show(std::move(empty));
}

void DocumentSession::show(Document document) {
    document_.replace(std::move(document));
    setFile({});
}

void DocumentSession::openExample(const QString& resource) {
    if (!mayClose())
        return;
    show(exampleDocument(resource));
    Q_EMIT exampleOpened(resource);
}

void DocumentSession::open() {
    const QString path = QFileDialog::getOpenFileName(window_, tr("Open"), QFileInfo(path_).path(),
                                                      tr("Documents and figures of Kriva (*.kriva *.svg)"));
    if (!path.isEmpty())
        openInstead(path);
}

void DocumentSession::openInstead(const QString& path) {
    if (!shared_.open.bringUp(path) && mayClose())
        openFile(path);
}

bool DocumentSession::openFile(const QString& path) {
    if (shared_.open.bringUp(path))
        return true;
    std::optional<AskedDocument> asked = askedDocument(path, window_);
    if (!asked)
        return false;
    File file;
    // A figure keeps its document inside, but saving must not put a document in the figure's place.
    if (path.endsWith(QLatin1String(".kriva"))) {
        file = {path, asked->hash, claim(path)};
        const auto answer =
            file.claim ? OpenElsewhereAnswer::Anyway : askAboutOpenElsewhere(QFileInfo(path).fileName(), window_);
        if (answer == OpenElsewhereAnswer::Cancel)
            return false;
        if (answer == OpenElsewhereAnswer::Copy)
            file = {};
        else if (!file.claim)
            file.claim = claimBeside(path);
    }
    document_.replace(std::move(asked->document));
    preferences_.addRecentFile(path);
    setFile(std::move(file));
    return true;
}

bool DocumentSession::recover(FoundRecovery found) {
    std::optional<AskedDocument> asked = askedDocument(readRecovery(found), found.files.document(), window_);
    if (!asked)
        return false;
    document_.replace(std::move(asked->document));
    setFile({});
    if (found.note && !found.note->path.isEmpty()) {
        setFile({found.note->path, found.note->fileHash, claimBeside(found.note->path)});
        watch_.lookSoon();
    }
    recovery_.adopt(std::move(found));
    document_.markUnsaved();
    return true;
}

bool DocumentSession::reload() {
    endEdits();
    if (document_.isModified() && !askToReload(name(), window_))
        return false;
    std::optional<AskedDocument> asked = askedDocument(path_, window_);
    if (!asked)
        return false;
    document_.replace(std::move(asked->document));
    setFile({path_, asked->hash, std::move(claim_)});
    return true;
}

SaveAnswer DocumentSession::askBeforeClosing() {
    if (recovery_.isKept())
        return SaveAnswer::Discard;
    if (document_.isModified())
        return askAboutUnsaved(name(), window_);
    const FileState state = watch_.lookIfWritten();
    if (state == FileState::Same)
        return SaveAnswer::Discard;
    return state == FileState::Gone ? askAboutGone(name(), window_) : askAboutChanged(name(), window_);
}

bool DocumentSession::follow(SaveAnswer answer, const QString& path) {
    switch (answer) {
    case SaveAnswer::Save:
        return save();
    case SaveAnswer::SaveAs:
        return saveAs();
    case SaveAnswer::Overwrite:
        return write(path);
    case SaveAnswer::Reload:
        reload();
        return false;
    case SaveAnswer::Discard:
        return true;
    case SaveAnswer::Cancel:
        return false;
    }
    return false;
}

void DocumentSession::endEdits() {
    commitTyping(*window_);
    document_.endGesture();
}

void DocumentSession::keepForNextStart() {
    commitTyping(*window_);
    recovery_.keep();
}

bool DocumentSession::mayClose() {
    endEdits();
    return follow(askBeforeClosing(), path_);
}

DocumentSession::Claim DocumentSession::claim(const QString& path) {
    auto claimed = shared_.open.claim(path, this);
    Claim* mine = std::get_if<Claim>(&claimed);
    return mine ? std::move(*mine) : nullptr;
}

void DocumentSession::setFile(File file) {
    path_ = std::move(file.path);
    claim_ = std::move(file.claim);
    watch_.watch(path_, file.hash);
    recovery_.setFile(path_.isEmpty() ? path_ : QFileInfo(path_).absoluteFilePath(), file.hash);
    Q_EMIT pathChanged();
}

void DocumentSession::bringUp() const {
    window_->isMinimized() ? window_->showNormal() : window_->show();
    window_->raise();
    window_->activateWindow();
}

} // namespace kriva::ui
