#include "ui/document/safe_write.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QScopeGuard>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kriva::ui {
namespace {

/// As many links as Linux follows in one path.
constexpr int kMostLinks = 40;

[[nodiscard]] WriteError writeError(int systemError) {
    switch (systemError) {
    case ENOENT:
    case ENOTDIR:
        return {WriteFault::NoFolder, systemError};
    case EACCES:
    case EPERM:
    case EROFS:
        return {WriteFault::Denied, systemError};
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return {WriteFault::Full, systemError};
    default:
        return {WriteFault::Failed, systemError};
    }
}

/// What the call just made left in errno. Qt may fail without one; a failure it stays.
[[nodiscard]] WriteError lastError() {
    return writeError(errno != 0 ? errno : EIO);
}

/// The path of the file itself: QSaveFile would put a file in the place of its own choice, and it is that folder which
/// has to reach the disk.
[[nodiscard]] QString withLinksFollowed(const QString& path) {
    QFileInfo file(path);
    for (int links = 0; links < kMostLinks && file.isSymLink(); ++links)
        file.setFile(file.symLinkTarget());
    return file.filePath();
}

/// Whether a file may be put there: only where nothing is, or a regular file.
[[nodiscard]] std::optional<WriteError> targetError(const QString& target) {
    struct stat status = {};
    if (::lstat(QFile::encodeName(target).constData(), &status) != 0)
        return errno == ENOENT ? std::nullopt : std::optional(lastError());
    if (!S_ISREG(status.st_mode))
        return WriteError{WriteFault::NotRegular};
    return std::nullopt;
}

/// Writes until all is out and on the disk. Unbuffered, a write may take less than it was given.
[[nodiscard]] std::optional<WriteError> writeAll(QSaveFile& file, QByteArrayView bytes) {
    while (!bytes.isEmpty()) {
        errno = 0;
        const qint64 count = file.write(bytes.data(), bytes.size());
        if (count <= 0)
            return lastError();
        bytes = bytes.sliced(count);
    }
    errno = 0;
    if (!file.flush() || file.error() != QFileDevice::NoError || ::fsync(file.handle()) != 0)
        return lastError();
    return std::nullopt;
}

[[nodiscard]] std::optional<WriteError> writeAndCommit(QSaveFile& file, QByteArrayView bytes, WriteAccess access) {
    errno = 0;
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return lastError();
    auto error = access == WriteAccess::OwnerOnly && ::fchmod(file.handle(), S_IRUSR | S_IWUSR) != 0
                     ? std::optional(lastError())
                     : writeAll(file, bytes);
    if (error) {
        file.cancelWriting();
        return error;
    }
    errno = 0;
    if (!file.commit())
        return lastError();
    return std::nullopt;
}

} // namespace

std::optional<WriteError> safeWrite(const QString& path, QByteArrayView bytes, WriteAccess access) {
    const QString target = access == WriteAccess::OwnerOnly ? path : withLinksFollowed(path);
    if (const auto error = targetError(target))
        return error;

    // Opened first: a folder that cannot be opened must fail while the old file still stands.
    const QByteArray folderName = QFile::encodeName(QFileInfo(target).absolutePath());
    const int folder = ::open(folderName.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return lastError();
    const auto closing = qScopeGuard([folder] { ::close(folder); });

    QSaveFile file(target);
    if (const auto error = writeAndCommit(file, bytes, access))
        return error;
    // Some network file systems know no fsync of a folder (EINVAL): there the exchange is as safe as it gets.
    if (::fsync(folder) != 0 && errno != EINVAL)
        return lastError();
    return std::nullopt;
}

} // namespace kriva::ui
