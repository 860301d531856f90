#pragma once

#include <QString>

#include <optional>
#include <sys/types.h>

namespace kriva::ui {

/// Whose a file is, and who may do what with it.
struct FileRights {
    uid_t owner = 0;
    gid_t group = 0;
    mode_t permissions = 0;
    bool operator==(const FileRights&) const = default;
};

/// Of the file behind links; nothing where there is none.
[[nodiscard]] std::optional<FileRights> rightsOf(const QString& path);

/// Of an open file.
[[nodiscard]] std::optional<FileRights> rightsOf(int file);

/// Gives an open file of this person's the rights of another one, as far as the system lets them. Where it does not,
/// the file is open to fewer people than the other one, never to more.
void takeOverRights(int file, const FileRights& others);

/// Whether a file has the rights that it had before it was written; a new one lost none.
[[nodiscard]] bool keptRights(const std::optional<FileRights>& before, const QString& path);

} // namespace kriva::ui
