#pragma once

#include "ui/document/safe_write.h"

#include <QDateTime>

namespace kriva::ui {

/// What is to be known about unsaved work besides the work itself.
struct RecoveryNote {
    QString path;            ///< of the document's file; empty where it has none
    QByteArray fileHash;     ///< contentHash() of that file when it was opened or saved; empty where it has none
    QByteArray hash;         ///< of the work
    QByteArray previousHash; ///< of the work before, which is there until the new one is; empty at first
    QDateTime time;          ///< when the work was as it is
    bool operator==(const RecoveryNote&) const = default;
};

/// As JSON, with a sum over all of it: a note that was damaged never names a wrong file.
[[nodiscard]] QByteArray writeNote(const RecoveryNote& note);
/// Nothing where a single byte is not as it was written.
[[nodiscard]] std::optional<RecoveryNote> readNote(const QByteArray& bytes);

/// The two files and the lock of one document's unsaved work: UUID.kriva, UUID.json, UUID.lock.
struct RecoveryFiles {
    QString folder;
    QString id; ///< a UUID without braces
    [[nodiscard]] QString document() const { return name(".kriva"); }
    [[nodiscard]] QString note() const { return name(".json"); }
    [[nodiscard]] QString lock() const { return name(".lock"); }

  private:
    [[nodiscard]] QString name(const char* suffix) const {
        return QStringLiteral("%1/%2%3").arg(folder, id, QLatin1String(suffix));
    }
};

/// Writes both files. The note comes first and knows the work that is there too, so that at each moment note and work
/// fit. `note.hash` is that of the bytes.
[[nodiscard]] std::optional<WriteError> writeRecovery(const RecoveryFiles& files, const RecoveryNote& note,
                                                      QByteArrayView document);

/// Removes both, the work first: what was given up is not offered again.
void removeRecovery(const RecoveryFiles& files);

} // namespace kriva::ui
