#include "ui/document/recovery/found_recoveries.h"

#include "ui/document/sharing/content_hash.h"
#include "ui/document/state_folder.h"

#include <QDir>
#include <QLockFile>
#include <QSet>
#include <QUuid>

#include <algorithm>

namespace kriva::ui {
namespace {

/// A note has a path and some hashes in it; a path has at most 4,096 bytes.
constexpr qint64 kLargestNote = 64 << 10;

[[nodiscard]] std::variant<QByteArray, ReadError> readOwn(const QString& path, qint64 limit) {
    return boundedRead(path, limit, ReadLinks::Refused);
}

[[nodiscard]] std::optional<RecoveryNote> loadNote(const RecoveryFiles& files) {
    const auto bytes = readOwn(files.note(), kLargestNote);
    const QByteArray* read = std::get_if<QByteArray>(&bytes);
    return read ? readNote(*read) : std::nullopt;
}

[[nodiscard]] bool isThere(const QFileInfo& file) {
    return file.exists() || file.isSymLink();
}

/// Reads the work once, to see what is left of it.
void lookAt(FoundRecovery& found) {
    if (!isThere(QFileInfo(found.files.document()))) {
        found.state = RecoveryState::Missing;
        return;
    }
    const auto bytes = readRecovery(found);
    found.state = RecoveryState::Unreadable;
    if (const QByteArray* read = std::get_if<QByteArray>(&bytes))
        found.hash = contentHash(*read);
    else
        return;
    if (found.note && (found.hash == found.note->hash || found.hash == found.note->previousHash))
        found.state = RecoveryState::Whole;
    else if (std::holds_alternative<LoadedFile>(documentFrom(bytes)))
        found.state = RecoveryState::Damaged;
}

/// Nothing where another program has it, or where there is nothing to recover.
[[nodiscard]] std::optional<FoundRecovery> take(RecoveryFiles files) {
    auto lock = std::make_unique<QLockFile>(files.lock());
    if (!lockNow(*lock))
        return {};
    const QFileInfo document(files.document());
    const QFileInfo note(files.note());
    if (!isThere(document) && !isThere(note))
        return {};
    FoundRecovery found{std::move(files), std::move(lock), {}, {}, {}, {}};
    found.note = loadNote(found.files);
    lookAt(found);
    found.time = found.note ? found.note->time.toLocalTime() : (isThere(document) ? document : note).lastModified();
    return found;
}

} // namespace

std::vector<FoundRecovery> takeRecoveries(const QString& folder) {
    QSet<QString> ids;
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::System | QDir::Hidden)) {
        const QString id = name.section(QLatin1Char('.'), 0, 0);
        if (!QUuid::fromString(id).isNull())
            ids.insert(id);
    }
    std::vector<FoundRecovery> found;
    for (const QString& id : ids)
        if (std::optional<FoundRecovery> one = take({folder, id}))
            found.push_back(std::move(*one));
    std::ranges::sort(found, [](const FoundRecovery& a, const FoundRecovery& b) { return a.time > b.time; });
    return found;
}

std::variant<QByteArray, ReadError> readRecovery(const FoundRecovery& found) {
    return readOwn(found.files.document(), kLargestFile);
}

void discardRecovery(FoundRecovery found) {
    removeRecovery(found.files);
}

} // namespace kriva::ui
