#include "core/io/json/document_json.h"
#include "ui/base/preferences.h"
#include "ui/document/error_text.h"
#include "ui/document/file_rights.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/window/dialogs/document_questions.h"
#include "ui/window/document_session.h"

#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace kriva::ui {

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
    endEdits();
    return follow(askBeforeWriting(path), path);
}

SaveAnswer DocumentSession::askBeforeWriting(const QString& path) {
    const QString file = QFileInfo(path).fileName();
    const bool isOwn = path == path_ || (claim_ && claim_->isOn(path));
    if (isOwn && watch_.look() == FileState::Changed)
        return askToOverwriteChanged(file, window_);
    const bool comesFirst = isOwn && claim_ ? claim_->comesFirst() : claim(path) != nullptr;
    return comesFirst ? SaveAnswer::Overwrite : askToOverwriteOpen(file, window_);
}

bool DocumentSession::write(const QString& path) {
    const std::optional<FileRights> before = rightsOf(path);
    const QByteArray bytes = QByteArray::fromStdString(writeDocument(document_.value()));
    if (const std::optional<WriteError> error = safeWrite(path, bytes))
        return tellNotSaved(errorText(*error, path), window_) && saveAs();
    document_.markSaved();
    preferences_.addRecentFile(path);
    const bool isOwn = claim_ && claim_->isOn(path);
    setFile({path, contentHash(bytes), isOwn ? std::move(claim_) : claimBeside(path)});
    if (!keptRights(before, path))
        Q_EMIT told(lostRightsText(path));
    return true;
}

} // namespace kriva::ui
