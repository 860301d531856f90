#include "ui/document/file_rights.h"

#include <QFile>

#include <sys/stat.h>
#include <unistd.h>

namespace kriva::ui {
namespace {

[[nodiscard]] FileRights rightsIn(const struct stat& status) {
    return {status.st_uid, status.st_gid, status.st_mode & 07777};
}

} // namespace

std::optional<FileRights> rightsOf(const QString& path) {
    struct stat status = {};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0)
        return {};
    return rightsIn(status);
}

std::optional<FileRights> rightsOf(int file) {
    struct stat status = {};
    if (::fstat(file, &status) != 0)
        return {};
    return rightsIn(status);
}

void takeOverRights(int file, const FileRights& others) {
    const auto made = rightsOf(file);
    if (!made)
        return;
    const bool isOther = made->owner != others.owner || made->group != others.group;
    // Who may not give a file away may still give it to a group of their own.
    const bool isGiven = !isOther || ::fchown(file, others.owner, others.group) == 0 ||
                         ::fchown(file, static_cast<uid_t>(-1), others.group) == 0;
    const auto now = isGiven ? rightsOf(file) : made;
    if (!now)
        return;
    mode_t permissions = others.permissions;
    if (now->group != others.group) // what the other group might is not for this one
        permissions &= ~static_cast<mode_t>(S_ISUID | S_ISGID | S_IRWXG) | ((permissions & S_IRWXO) << 3);
    if (now->owner != others.owner)
        permissions &= ~static_cast<mode_t>(S_ISUID);
    if (now->permissions != permissions)
        ::fchmod(file, permissions); // refused, it stays the owner's alone, as it was made
}

bool keptRights(const std::optional<FileRights>& before, const QString& path) {
    return !before || rightsOf(path) == before;
}

} // namespace kriva::ui
