#include "ui/document/bounded_read.h"

#include <QFile>
#include <QScopeGuard>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kriva::ui {
namespace {

constexpr qint64 kChunk = 256 << 10;

[[nodiscard]] ReadError readError(int systemError) {
    switch (systemError) {
    case ENOENT:
    case ENOTDIR:
        return {ReadFault::Missing, systemError};
    case EACCES:
    case EPERM:
        return {ReadFault::Denied, systemError};
    case ENXIO: // a socket, or a device without a driver
    case ELOOP: // a link where none may be, or links in a ring
        return {ReadFault::NotRegular, systemError};
    default:
        return {ReadFault::Failed, systemError};
    }
}

} // namespace

std::variant<QByteArray, ReadError> boundedRead(const QString& path, qint64 limit, ReadLinks links) {
    // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
    const int flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (links == ReadLinks::Refused ? O_NOFOLLOW : 0);
    const int file = ::open(QFile::encodeName(path).constData(), flags);
    if (file < 0)
        return readError(errno);
    const auto closing = qScopeGuard([file] { ::close(file); });

    struct stat status = {};
    if (::fstat(file, &status) != 0)
        return readError(errno);
    if (!S_ISREG(status.st_mode))
        return ReadError{ReadFault::NotRegular};
    if (status.st_size > limit)
        return ReadError{ReadFault::TooLarge};

    QByteArray bytes;
    bytes.reserve(status.st_size + 1);
    while (bytes.size() <= limit) {
        const qsizetype before = bytes.size();
        const qint64 room = std::min(kChunk, limit + 1 - before);
        bytes.resize(before + room);
        const ssize_t count = ::read(file, bytes.data() + before, static_cast<std::size_t>(room));
        const int systemError = errno;
        bytes.resize(before + std::max<ssize_t>(count, 0));
        if (count == 0)
            return bytes;
        if (count < 0 && systemError != EINTR)
            return readError(systemError);
    }
    return ReadError{ReadFault::TooLarge};
}

} // namespace kriva::ui
