#include "ui/document/recovery/recovery_files.h"

#include "ui/document/sharing/content_hash.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace kriva::ui {
namespace {

constexpr QLatin1String kPath("path");
constexpr QLatin1String kFileHash("fileHash");
constexpr QLatin1String kHash("hash");
constexpr QLatin1String kPreviousHash("previousHash");
constexpr QLatin1String kTime("time");
constexpr QLatin1String kSum("sum");

/// QJsonObject keeps its keys in order: the same fields are the same bytes.
[[nodiscard]] QString sumOf(const QJsonObject& fields) {
    return QString::fromLatin1(contentHash(QJsonDocument(fields).toJson(QJsonDocument::Compact)));
}

[[nodiscard]] QByteArray hashIn(const QJsonObject& fields, QLatin1String key) {
    return fields[key].toString().toLatin1();
}

} // namespace

QByteArray writeNote(const RecoveryNote& note) {
    QJsonObject fields{{kPath, note.path.isEmpty() ? QJsonValue() : QJsonValue(note.path)},
                       {kFileHash, QString::fromLatin1(note.fileHash)},
                       {kHash, QString::fromLatin1(note.hash)},
                       {kPreviousHash, QString::fromLatin1(note.previousHash)},
                       {kTime, note.time.toUTC().toString(Qt::ISODateWithMs)}};
    fields.insert(kSum, sumOf(fields));
    return QJsonDocument(fields).toJson();
}

std::optional<RecoveryNote> readNote(const QByteArray& bytes) {
    const QJsonDocument read = QJsonDocument::fromJson(bytes);
    QJsonObject fields = read.object();
    const QString sum = fields.take(kSum).toString();
    // What stands between the fields counts too: only what was written here comes back.
    if (read.toJson() != bytes || sum != sumOf(fields))
        return {};
    return RecoveryNote{fields[kPath].toString(), hashIn(fields, kFileHash), hashIn(fields, kHash),
                        hashIn(fields, kPreviousHash),
                        QDateTime::fromString(fields[kTime].toString(), Qt::ISODateWithMs)};
}

std::optional<WriteError> writeRecovery(const RecoveryFiles& files, const RecoveryNote& note, QByteArrayView document) {
    if (const auto error = safeWrite(files.note(), writeNote(note), WriteAccess::OwnerOnly))
        return error;
    return safeWrite(files.document(), document, WriteAccess::OwnerOnly);
}

void removeRecovery(const RecoveryFiles& files) {
    if (QFile::remove(files.document()) || !QFile::exists(files.document()))
        QFile::remove(files.note());
}

} // namespace kriva::ui
