#include "ui/document/sharing/open_files.h"

#include "ui/document/recovery/state_folder.h"
#include "ui/document/sharing/content_hash.h"

#include <QFileInfo>
#include <QLockFile>

namespace kriva::ui {
namespace {

/// The same for every name of a file. One that is not there yet has the name that it will have.
[[nodiscard]] QString canonicalPath(const QString& path) {
    const QFileInfo file(path);
    QString canonical = file.canonicalFilePath();
    if (!canonical.isEmpty())
        return canonical;
    const QString folder = QFileInfo(file.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? file.absoluteFilePath() : QStringLiteral("%1/%2").arg(folder, file.fileName());
}

/// A lock that is not locked yet; null where there is no place for one.
[[nodiscard]] std::unique_ptr<QLockFile> lockFor(const QString& key) {
    const auto folder = privateFolder(QStringLiteral("locks"));
    const QString* path = std::get_if<QString>(&folder);
    if (!path)
        return nullptr;
    // By its hash: a path may be longer than a name can be.
    return std::make_unique<QLockFile>(
        QStringLiteral("%1/%2.lock").arg(*path, QString::fromLatin1(contentHash(key.toUtf8()))));
}

} // namespace

OpenFiles::Claim::Claim(OpenFiles& files, QString key, std::unique_ptr<QLockFile> lock)
    : files_(files)
    , key_(std::move(key))
    , lock_(std::move(lock)) {}

OpenFiles::Claim::~Claim() {
    files_.holders_.erase(key_);
}

OpenFiles::OpenFiles(QObject* parent)
    : QObject(parent) {}

OpenFiles::~OpenFiles() = default;

std::variant<std::unique_ptr<OpenFiles::Claim>, OpenFiles::HeldElsewhere> OpenFiles::claim(const QString& path,
                                                                                           const QObject* holder) {
    const QString key = canonicalPath(path);
    if (holders_.contains(key))
        return HeldElsewhere{};
    auto lock = lockFor(key);
    if (lock && !lockNow(*lock)) {
        if (lock->error() == QLockFile::LockFailedError)
            return HeldElsewhere{};
        lock.reset(); // no place for a lock is no reason to keep anybody from a file
    }
    holders_[key] = holder;
    return std::unique_ptr<Claim>(new Claim(*this, key, std::move(lock)));
}

const QObject* OpenFiles::holderOf(const QString& path) const {
    const auto found = holders_.find(canonicalPath(path));
    return found == holders_.end() ? nullptr : found->second;
}

bool OpenFiles::bringUp(const QString& path) {
    const QObject* holder = holderOf(path);
    if (holder)
        Q_EMIT bringUpAsked(holder);
    return holder != nullptr;
}

} // namespace kriva::ui
