#pragma once

#include <QByteArrayView>
#include <QString>

#include <optional>

namespace kriva::ui {

/// Why a file could not be written, as far as a person can do something about it.
enum class WriteFault {
    NotRegular, ///< The target is a folder, a pipe, a device, or a link where none may be.
    NoFolder,   ///< The folder is not there.
    Denied,     ///< File or folder are read-only for this person.
    Full,       ///< No space is left, or the person's share of it is used up.
    Failed      ///< Anything else that the system reports.
};

struct WriteError {
    WriteFault fault = WriteFault::Failed;
    int systemError = 0; ///< errno, for the system's own words about it: qt_error_string().
    bool operator==(const WriteError&) const = default;
};

enum class WriteAccess {
    AsFound,  ///< An existing file keeps its owner and permissions, a new one gets the usual ones; links are followed.
    OwnerOnly ///< The file can be read and written by its owner alone; links are refused.
};

/// Puts `bytes` in the place of the file at `path`, whole or not at all. Without an error, they are on the disk and
/// survive a loss of power. With one, the old file stands as it was; only if the folder itself could not be brought to
/// the disk after the exchange, the new one does already.
///
/// Owner, group and permissions of an existing file are kept as far as the system lets this person; where it does not,
/// the new file is open to fewer people than the old one, never to more: see keptRights() in file_rights.h.
[[nodiscard]] std::optional<WriteError> safeWrite(const QString& path, QByteArrayView bytes,
                                                  WriteAccess access = WriteAccess::AsFound);

} // namespace kriva::ui
