#include "ui/document/document_file.h"

#include "core/io/open.h"
#include "core/io/svg/drawn_document.h"

namespace kriva::ui {

std::variant<LoadedFile, OpenError> documentFrom(const std::variant<QByteArray, ReadError>& bytes) {
    if (const ReadError* error = std::get_if<ReadError>(&bytes))
        return *error;
    const QByteArray& read = std::get<QByteArray>(bytes);
    const std::string_view text(read.constData(), static_cast<std::size_t>(read.size()));
    std::variant<Document, FileError> document = readAnyDocument(text);
    if (FileError* error = std::get_if<FileError>(&document))
        return std::move(*error);
    LoadedFile loaded{std::get<Document>(std::move(document))};
    if (isXml(text))
        loaded.drawn = drawnDocument(text, loaded.document);
    return loaded;
}

} // namespace kriva::ui
