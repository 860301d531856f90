#pragma once

#include <QByteArray>
#include <QCryptographicHash>

namespace kriva::ui {

/// What tells the content of a file from any other: 64 hexadecimal digits.
[[nodiscard]] inline QByteArray contentHash(QByteArrayView bytes) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(bytes);
    return hash.result().toHex();
}

} // namespace kriva::ui
