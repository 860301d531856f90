#include "ui/document/sharing/open_files.h"

#include "ui/document/sharing/content_hash.h"
#include "ui/document/state_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QUuid>

#include <algorithm>
#include <optional>
#include <utility>

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

/// The name of a file's locks, without what tells them apart; nothing where there is no place for them. By its hash: a
/// path may be longer than a name can be.
[[nodiscard]] std::optional<QString> lockName(const QString& key) {
    const auto folder = privateFolder(QStringLiteral("locks"));
    const QString* path = std::get_if<QString>(&folder);
    return path ? std::optional(QStringLiteral("%1/%2").arg(*path, QString::fromLatin1(contentHash(key.toUtf8()))))
                : std::nullopt;
}

enum class Locking {
    Done,
    Refused, ///< somebody has it
    Failed   ///< there is no place for it, which is no reason to keep anybody from a file
};

[[nodiscard]] Locking locked(QLockFile& lock) {
    if (lockNow(lock))
        return Locking::Done;
    return lock.error() == QLockFile::LockFailedError ? Locking::Refused : Locking::Failed;
}

/// Whether a program has the file open beside the first one, or did so before that one went. Locks of programs that are
/// no more are removed.
[[nodiscard]] bool isOpenBeside(const QString& name) {
    const QFileInfo own(name);
    for (const QString& other : QDir(own.path()).entryList({own.fileName() + QStringLiteral(".*.lock")}, QDir::Files)) {
        QLockFile lock(QStringLiteral("%1/%2").arg(own.path(), other));
        if (locked(lock) == Locking::Refused)
            return true;
    }
    return false;
}

[[nodiscard]] std::unique_ptr<QLockFile> firstLock(const QString& name) {
    return std::make_unique<QLockFile>(name + QStringLiteral(".lock"));
}

/// Null where there is no place for it.
[[nodiscard]] std::unique_ptr<QLockFile> lockedBeside(const QString& name) {
    const QString own = QUuid::createUuid().toString(QUuid::WithoutBraces);
    auto lock = std::make_unique<QLockFile>(QStringLiteral("%1.%2.lock").arg(name, own));
    return lockNow(*lock) ? std::move(lock) : nullptr;
}

} // namespace

OpenFiles::Claim::Claim(OpenFiles& files, QString key, const QObject* holder)
    : files_(files)
    , key_(std::move(key))
    , holder_(holder) {}

OpenFiles::Claim::~Claim() {
    files_.release(key_, holder_);
}

bool OpenFiles::Claim::isOn(const QString& path) const {
    return canonicalPath(path) == key_;
}

bool OpenFiles::Claim::comesFirst() const {
    Held& held = files_.held_.at(key_);
    if (held.holders.front() != holder_)
        return false;
    const std::optional<QString> name = held.beside ? lockName(key_) : std::nullopt;
    if (!name)
        return true;
    auto first = firstLock(*name);
    if (locked(*first) == Locking::Refused)
        return false;
    held.first = std::move(first);
    held.beside.reset();
    return true;
}

OpenFiles::OpenFiles(QObject* parent)
    : QObject(parent) {}

OpenFiles::~OpenFiles() = default;

std::variant<std::unique_ptr<OpenFiles::Claim>, OpenFiles::HeldElsewhere> OpenFiles::claim(const QString& path,
                                                                                           const QObject* holder) {
    const QString key = canonicalPath(path);
    if (held_.contains(key))
        return HeldElsewhere{};
    Held held;
    if (const std::optional<QString> name = lockName(key)) {
        held.first = firstLock(*name);
        const Locking locking = locked(*held.first);
        if (locking == Locking::Refused || isOpenBeside(*name))
            return HeldElsewhere{};
        if (locking == Locking::Failed)
            held.first.reset();
    }
    return claimed(key, std::move(held), holder);
}

std::unique_ptr<OpenFiles::Claim> OpenFiles::claimBeside(const QString& path, const QObject* holder) {
    auto alone = claim(path, holder);
    if (auto* mine = std::get_if<std::unique_ptr<Claim>>(&alone))
        return std::move(*mine);
    const QString key = canonicalPath(path);
    Held held;
    if (const std::optional<QString> name = lockName(key); name && !held_.contains(key))
        held.beside = lockedBeside(*name);
    return claimed(key, std::move(held), holder);
}

std::unique_ptr<OpenFiles::Claim> OpenFiles::claimed(const QString& key, Held held, const QObject* holder) {
    held_.try_emplace(key, std::move(held)).first->second.holders.push_back(holder);
    return std::unique_ptr<Claim>(new Claim(*this, key, holder));
}

void OpenFiles::release(const QString& key, const QObject* holder) {
    std::vector<const QObject*>& holders = held_.at(key).holders;
    holders.erase(std::ranges::find(holders, holder));
    if (holders.empty())
        held_.erase(key);
}

const QObject* OpenFiles::holderOf(const QString& path) const {
    const auto found = held_.find(canonicalPath(path));
    return found == held_.end() ? nullptr : found->second.holders.front();
}

bool OpenFiles::bringUp(const QString& path) {
    const QObject* holder = holderOf(path);
    if (holder)
        Q_EMIT bringUpAsked(holder);
    return holder != nullptr;
}

} // namespace kriva::ui
