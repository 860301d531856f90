#pragma once

#include <QByteArray>

namespace kriva::test {

/// The unsaved work that save_once writes.
inline constexpr const char* kRecoveryId = "6f1d8a3e-35a1-4e0c-9d55-0d6a3f1b2c47";

/// `size` bytes that differ in every place from those of the next version, and tell a cut or mixed file from a whole
/// one.
[[nodiscard]] inline QByteArray savedVersion(int version, int size) {
    QByteArray bytes = QByteArray::number(version).append('\n');
    bytes.resize(size, static_cast<char>('A' + version % 26));
    return bytes;
}

} // namespace kriva::test
