#include "ui/document/state_folder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QScopeGuard>
#include <QSysInfo>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kriva::ui {
namespace {

constexpr mode_t kOwnersFolder = S_IRWXU;

[[nodiscard]] WriteError folderError(int systemError) {
    switch (systemError) {
    case ELOOP:
    case ENOTDIR:
    case EEXIST:
        return {WriteFault::NotRegular, systemError};
    case ENOENT:
        return {WriteFault::NoFolder, systemError};
    case EACCES:
    case EPERM:
    case EROFS:
        return {WriteFault::Denied, systemError};
    case ENOSPC:
    case EDQUOT:
        return {WriteFault::Full, systemError};
    default:
        return {WriteFault::Failed, systemError};
    }
}

/// Makes the folder, or sees to it that the one that is there is this person's alone.
[[nodiscard]] std::optional<WriteError> makePrivate(const QString& path) {
    const QByteArray name = QFile::encodeName(path);
    if (::mkdir(name.constData(), kOwnersFolder) != 0 && errno != EEXIST)
        return folderError(errno);
    const int folder = ::open(name.constData(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0)
        return folderError(errno);
    const auto closing = qScopeGuard([folder] { ::close(folder); });
    struct stat status = {};
    if (::fstat(folder, &status) != 0)
        return folderError(errno);
    if (status.st_uid != ::geteuid())
        return folderError(EPERM);
    if ((status.st_mode & 07777) != kOwnersFolder && ::fchmod(folder, kOwnersFolder) != 0)
        return folderError(errno);
    return std::nullopt;
}

/// The lock of a program that is no more and had the number that this one has now, as happens where a container starts
/// again. Where this very program holds it, the system knows and refuses.
[[nodiscard]] bool isTakenOver(QLockFile& lock) {
    qint64 process = 0;
    QString host;
    QString program;
    return lock.getLockInfo(&process, &host, &program) && process == QCoreApplication::applicationPid() &&
           host == QSysInfo::machineHostName() && lock.removeStaleLockFile() && lock.tryLock(0);
}

} // namespace

QString stateFolder() {
    // A relative path counts as none, says the standard that the variable is from.
    const QString home = qEnvironmentVariable("XDG_STATE_HOME");
    return QDir(QDir::isAbsolutePath(home) ? home : QDir::homePath() + QStringLiteral("/.local/state"))
        .filePath(QStringLiteral("kriva"));
}

std::variant<QString, WriteError> privateFolder(const QString& name) {
    const QString state = stateFolder();
    // Whether this is done shows at the next step, with the system's reason.
    QDir().mkpath(QFileInfo(state).path());
    const QString folder = QDir(state).filePath(name);
    for (const QString& path : {state, folder})
        if (const auto error = makePrivate(path))
            return *error;
    return folder;
}

bool lockNow(QLockFile& lock) {
    lock.setStaleLockTime(0); // a program may be open for weeks: only its end makes a lock stale
    if (lock.tryLock(0) || isTakenOver(lock)) {
        QFile::setPermissions(lock.fileName(), QFile::ReadOwner | QFile::WriteOwner);
        return true;
    }
    return false;
}

} // namespace kriva::ui
