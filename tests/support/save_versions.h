#pragma once

#include <QByteArray>

namespace kriva::test {

/// `size` bytes that differ in every place from those of the next version, and tell a cut or mixed file from a whole
/// one.
[[nodiscard]] inline QByteArray savedVersion(int version, int size) {
    QByteArray bytes = QByteArray::number(version).append('\n');
    bytes.resize(size, static_cast<char>('A' + version % 26));
    return bytes;
}

} // namespace kriva::test
