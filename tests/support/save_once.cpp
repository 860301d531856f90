// Saves a file under a fault, for safe_write_test and recovery_files_test: a process of its own, since the fault may
// be a kill.
//   save_once PATH SIZE unnamed|named|recovery KIND CALL ERRNO LASTING
//       writes version 1 in the place of version 0, `named` as where no files without a name are, `recovery` as unsaved
//       work into the folder PATH; exit code 0: said to be saved, 1: refused. Prints the system calls that were made.
//   save_once PATH SIZE forever
//       writes version 1, 2, ... and prints each after it is saved.
#include "tests/support/failing_syscalls.h"
#include "tests/support/save_versions.h"
#include "ui/document/recovery/recovery_files.h"
#include "ui/document/sharing/content_hash.h"

#include <QFile>

#include <charconv>
#include <cstring>
#include <unistd.h>

namespace {

using kriva::test::savedVersion;

int number(const char* text) {
    int value = 0;
    std::from_chars(text, text + std::strlen(text), value);
    return value;
}

void print(const std::string& text) {
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0)
        ::_exit(2);
}

bool save(const QString& path, int size, std::string_view how) {
    const QByteArray bytes = savedVersion(1, size);
    if (how != "recovery")
        return !kriva::ui::safeWrite(path, bytes);
    const kriva::ui::RecoveryNote note{QStringLiteral("/home/a/arch.kriva"),
                                       {},
                                       kriva::ui::contentHash(bytes),
                                       kriva::ui::contentHash(savedVersion(0, size)),
                                       QDateTime(QDate(2026, 2, 1), QTime(1, 0), Qt::UTC)};
    return !kriva::ui::writeRecovery({path, QString::fromLatin1(kriva::test::kRecoveryId)}, note, bytes);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 8)
        return 2;
    const QString path = QFile::decodeName(argv[1]);
    const int size = number(argv[2]);
    const std::string_view how = argv[3];
    if (argc == 8) {
        if (how == "named")
            kriva::test::refuseUnnamedFiles();
        kriva::test::arm({static_cast<kriva::test::FaultKind>(number(argv[4])), number(argv[5]), number(argv[6]),
                          number(argv[7]) != 0});
        const bool isSaved = save(path, size, how);
        print(kriva::test::disarm());
        return isSaved ? 0 : 1;
    }
    for (int version = 1;; ++version) {
        if (kriva::ui::safeWrite(path, savedVersion(version, size)))
            return 1;
        print(QByteArray::number(version).append('\n').toStdString());
    }
}
