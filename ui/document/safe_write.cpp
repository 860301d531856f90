#include "ui/document/safe_write.h"

#include "ui/document/file_rights.h"

#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>

#include <cerrno>
#include <cstdio> // renameat
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kriva::ui {
namespace {

/// As many links as Linux follows in one path.
constexpr int kMostLinks = 40;

/// Temporary names are drawn from 2^64: a second one that is taken is no chance.
constexpr int kMostNames = 8;

constexpr mode_t kPermissions = 07777;
constexpr mode_t kUsual = 0666; // what the person's mask leaves of it
constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

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

[[nodiscard]] WriteError lastError() {
    return writeError(errno);
}

/// The path of the file itself: it is that folder which has to reach the disk.
[[nodiscard]] QString withLinksFollowed(const QString& path) {
    QFileInfo file(path);
    for (int links = 0; links < kMostLinks && file.isSymLink(); ++links)
        file.setFile(file.symLinkTarget());
    return file.filePath();
}

/// An open file or folder, closed at its end.
class Descriptor {
  public:
    explicit Descriptor(int number)
        : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Q_DISABLE_COPY(Descriptor)
    [[nodiscard]] int operator*() const { return number_; }
    [[nodiscard]] bool isOpen() const { return number_ >= 0; }

  private:
    int number_;
};

/// The file that is to stand in a folder, and what stands there now.
struct Target {
    int folder = -1;
    QByteArray name;
    std::optional<FileRights> old = {}; ///< nothing where the file is new
    WriteAccess access = WriteAccess::AsFound;
};

/// Fills in the old file's rights; refuses what is no regular file or may not be written.
[[nodiscard]] std::optional<WriteError> lookAtOld(Target& target) {
    struct stat status = {};
    if (::fstatat(target.folder, target.name.constData(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT ? std::nullopt : std::optional(lastError());
    if (!S_ISREG(status.st_mode))
        return WriteError{WriteFault::NotRegular};
    // An exchange needs no right to the file itself; who took it away from it wants it kept.
    if (::faccessat(target.folder, target.name.constData(), W_OK, AT_EACCESS) != 0)
        return lastError();
    target.old = FileRights{status.st_uid, status.st_gid, status.st_mode & kPermissions};
    return std::nullopt;
}

/// What a file is made with: nobody else opens it before it has the rights that it has in the end.
[[nodiscard]] mode_t firstPermissions(const Target& target) {
    return target.old || target.access == WriteAccess::OwnerOnly ? kOwnerOnly : kUsual;
}

/// The file is its owner's alone, whatever mask there is.
[[nodiscard]] std::optional<WriteError> closeToOthers(int file) {
    const auto rights = rightsOf(file);
    if (!rights || (rights->permissions != kOwnerOnly && ::fchmod(file, kOwnerOnly) != 0))
        return lastError();
    return std::nullopt;
}

/// Writes until all is out and on the disk. A write may take less than it was given.
[[nodiscard]] std::optional<WriteError> writeAll(int file, QByteArrayView bytes) {
    while (!bytes.isEmpty()) {
        const ssize_t count = ::write(file, bytes.data(), static_cast<std::size_t>(bytes.size()));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return writeError(count == 0 ? EIO : errno);
        bytes = bytes.sliced(count);
    }
    return ::fsync(file) == 0 ? std::nullopt : std::optional(lastError());
}

[[nodiscard]] std::optional<WriteError> fill(int file, const Target& target, QByteArrayView bytes) {
    if (target.access == WriteAccess::OwnerOnly) {
        if (const auto error = closeToOthers(file))
            return error;
    } else if (target.old) {
        takeOverRights(file, *target.old);
    }
    return writeAll(file, bytes);
}

/// Short, so that a file's own name may be as long as names can be.
[[nodiscard]] QByteArray temporaryName() {
    return ".kriva-" + QByteArray::number(QRandomGenerator::system()->generate64(), 36);
}

/// Makes something under a temporary name with `make(name)`, which is 0 or more where it is made. The name comes back,
/// empty where it failed for another reason than that the name is taken.
template <class Make>
[[nodiscard]] QByteArray underTemporaryName(Make make) {
    for (int i = 0; i < kMostNames; ++i) {
        QByteArray name = temporaryName();
        if (make(name.constData()) >= 0)
            return name;
        if (errno != EEXIST)
            break;
    }
    return {};
}

/// From the temporary name to the own one; the temporary one is gone in any case.
[[nodiscard]] std::optional<WriteError> exchange(const Target& target, const QByteArray& temporary) {
    if (::renameat(target.folder, temporary.constData(), target.folder, target.name.constData()) == 0)
        return std::nullopt;
    const WriteError error = lastError();
    ::unlinkat(target.folder, temporary.constData(), 0);
    return error;
}

/// Puts a file without a name, full and on the disk, in its place.
[[nodiscard]] std::optional<WriteError> giveName(int file, const Target& target) {
    const QByteArray unnamed = "/proc/self/fd/" + QByteArray::number(file);
    const auto link = [&](const char* name) {
        return ::linkat(AT_FDCWD, unnamed.constData(), target.folder, name, AT_SYMLINK_FOLLOW);
    };
    // A new file needs no exchange; where another program was first, it does.
    if (!target.old && link(target.name.constData()) == 0)
        return std::nullopt;
    if (!target.old && errno != EEXIST)
        return lastError();
    const QByteArray temporary = underTemporaryName(link);
    return temporary.isEmpty() ? std::optional(lastError()) : exchange(target, temporary);
}

/// A file without a name, of which nothing is left whenever the program ends. errno is EOPNOTSUPP where there are none.
[[nodiscard]] int openUnnamed(const Target& target) {
    const int file = ::faccessat(AT_FDCWD, "/proc/self/fd", X_OK, 0) == 0
                         ? ::openat(target.folder, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, firstPermissions(target))
                         : (errno = EOPNOTSUPP, -1);
    if (file < 0 && (errno == EISDIR || errno == EINVAL)) // what old kernels say
        errno = EOPNOTSUPP;
    return file;
}

[[nodiscard]] std::optional<WriteError> writeUnnamed(int file, const Target& target, QByteArrayView bytes) {
    const auto error = fill(file, target, bytes);
    return error ? error : giveName(file, target);
}

[[nodiscard]] std::optional<WriteError> writeNamed(const Target& target, QByteArrayView bytes) {
    int number = -1;
    const QByteArray temporary = underTemporaryName([&](const char* name) {
        return number = ::openat(target.folder, name, O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC,
                                 firstPermissions(target));
    });
    if (temporary.isEmpty())
        return lastError();
    const Descriptor file(number);
    if (const auto error = fill(*file, target, bytes)) {
        ::unlinkat(target.folder, temporary.constData(), 0);
        return error;
    }
    return exchange(target, temporary);
}

} // namespace

std::optional<WriteError> safeWrite(const QString& path, QByteArrayView bytes, WriteAccess access) {
    const QFileInfo file(access == WriteAccess::OwnerOnly ? path : withLinksFollowed(path));
    // Opened first: a folder that cannot be opened must fail while the old file still stands.
    const Descriptor folder(
        ::open(QFile::encodeName(file.absolutePath()).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.isOpen())
        return lastError();
    Target target{*folder, QFile::encodeName(file.fileName()), {}, access};
    if (target.name.isEmpty())
        return WriteError{WriteFault::NotRegular}; // the path names a folder
    if (const auto error = lookAtOld(target))
        return error;
    const Descriptor unnamed(openUnnamed(target));
    if (!unnamed.isOpen() && errno != EOPNOTSUPP)
        return lastError();
    if (const auto error = unnamed.isOpen() ? writeUnnamed(*unnamed, target, bytes) : writeNamed(target, bytes))
        return error;
    // Some network file systems know no fsync of a folder (EINVAL): there the exchange is as safe as it gets.
    if (::fsync(*folder) != 0 && errno != EINVAL)
        return lastError();
    return std::nullopt;
}

} // namespace kriva::ui
