#pragma once

#include <QByteArray>
#include <QString>

#include <variant>

namespace kriva::ui {

enum class ReadFault {
    Missing,    ///< There is no such file.
    NotRegular, ///< A folder, a pipe, a device or a socket.
    TooLarge,   ///< More bytes than the limit.
    Denied,     ///< This person may not read it.
    Failed      ///< Anything else that the system reports.
};

struct ReadError {
    ReadFault fault = ReadFault::Failed;
    int systemError = 0; ///< errno, or 0 if the system had nothing against it.
    bool operator==(const ReadError&) const = default;
};

/// The largest file that is read at all: 64 MiB.
inline constexpr qint64 kLargestFile = 64 << 20;

enum class ReadLinks {
    Followed,
    Refused ///< A link is no regular file.
};

/// All bytes of the regular file at `path`; never waits for a pipe or a device, and never holds more than one byte
/// above `limit`, however the file grows meanwhile.
[[nodiscard]] std::variant<QByteArray, ReadError> boundedRead(const QString& path, qint64 limit = kLargestFile,
                                                              ReadLinks links = ReadLinks::Followed);

} // namespace kriva::ui
