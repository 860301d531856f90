// Saves a file under a fault, for safe_write_test: a process of its own, since the fault may be a kill.
//   save_once PATH SIZE once KIND CALL ERRNO LASTING    writes version 1; exit code 0: said to be saved, 1: refused.
//                                                       Prints the system calls that were made.
//   save_once PATH SIZE forever                         writes version 1, 2, ... and prints each after it is saved.
#include "tests/support/failing_syscalls.h"
#include "tests/support/save_versions.h"
#include "ui/document/safe_write.h"

#include <QFile>

#include <charconv>
#include <cstring>
#include <unistd.h>

namespace {

int number(const char* text) {
    int value = 0;
    std::from_chars(text, text + std::strlen(text), value);
    return value;
}

void print(const std::string& text) {
    if (::write(STDOUT_FILENO, text.data(), text.size()) < 0)
        ::_exit(2);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 4 && argc != 8)
        return 2;
    const QString path = QFile::decodeName(argv[1]);
    const int size = number(argv[2]);
    if (argc == 8) {
        const QByteArray bytes = kriva::test::savedVersion(1, size);
        kriva::test::arm({static_cast<kriva::test::FaultKind>(number(argv[4])), number(argv[5]), number(argv[6]),
                          number(argv[7]) != 0});
        const bool isSaved = !kriva::ui::safeWrite(path, bytes);
        print(kriva::test::disarm());
        return isSaved ? 0 : 1;
    }
    for (int version = 1;; ++version) {
        if (kriva::ui::safeWrite(path, kriva::test::savedVersion(version, size)))
            return 1;
        print(QByteArray::number(version).append('\n').toStdString());
    }
}
