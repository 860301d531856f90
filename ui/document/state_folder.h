#pragma once

#include "ui/document/safe_write.h"

#include <variant>

class QLockFile;

namespace kriva::ui {

/// Where the program keeps what is of this machine and the moment: $XDG_STATE_HOME/kriva, by default
/// ~/.local/state/kriva.
[[nodiscard]] QString stateFolder();

/// The folder of this name in it, which its owner alone can look into; made where it is missing. Refused where a link,
/// a file or another person's folder is in its place.
[[nodiscard]] std::variant<QString, WriteError> privateFolder(const QString& name);

/// Locks without waiting. The lock of a program that is no more is taken over, also where this program has its number
/// now.
[[nodiscard]] bool lockNow(QLockFile& lock);

} // namespace kriva::ui
