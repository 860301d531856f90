#include "ui/document/document_file.h"

#include "core/document/document_json.h"
#include "core/io/open.h"

namespace kriva::ui {

std::variant<Document, OpenError> loadDocument(const QString& path) {
    return documentFrom(boundedRead(path));
}

std::variant<Document, OpenError> documentFrom(const std::variant<QByteArray, ReadError>& bytes) {
    if (const ReadError* error = std::get_if<ReadError>(&bytes))
        return *error;
    const QByteArray& text = std::get<QByteArray>(bytes);
    std::variant<Document, FileError> document =
        readAnyDocument({text.constData(), static_cast<std::size_t>(text.size())});
    if (FileError* error = std::get_if<FileError>(&document))
        return std::move(*error);
    return std::get<Document>(std::move(document));
}

std::optional<WriteError> saveDocument(const QString& path, const Document& document) {
    const std::string text = writeDocument(document);
    return safeWrite(path, {text.data(), static_cast<qsizetype>(text.size())});
}

} // namespace kriva::ui
