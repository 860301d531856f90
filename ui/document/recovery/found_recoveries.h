#pragma once

#include "ui/document/document_file.h"
#include "ui/document/recovery/recovery_files.h"

#include <QLockFile>

#include <memory>

namespace kriva::ui {

enum class RecoveryState {
    Whole,      ///< as it was written
    Damaged,    ///< the files were cut or changed: the document can be read, but what it says may be wrong
    Unreadable, ///< no document any more
    Missing     ///< the note alone: the work was not written any more, or was removed by another program
};

/// Unsaved work of a program that ended without being asked. As long as this lives, no other program takes it.
struct FoundRecovery {
    RecoveryFiles files;
    std::unique_ptr<QLockFile> lock;
    std::optional<RecoveryNote> note; ///< nothing where it was lost or damaged
    RecoveryState state = RecoveryState::Whole;
    QByteArray hash; ///< of the work as it is now
    QDateTime time;  ///< of the note, else of the file that is there
};

/// What is there and belongs to no program that runs, the last one first.
[[nodiscard]] std::vector<FoundRecovery> takeRecoveries(const QString& folder);

/// The work itself.
[[nodiscard]] std::variant<QByteArray, ReadError> readRecovery(const FoundRecovery& found);

/// Removes the work and gives it up.
void discardRecovery(FoundRecovery found);

} // namespace kriva::ui
