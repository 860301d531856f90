#include "ui/window/asked_document.h"

#include "ui/document/error_text.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/window/dialogs/document_questions.h"

#include <QFileInfo>

namespace kriva::ui {

std::optional<AskedDocument> askedDocument(const QString& path, QWidget* window) {
    return askedDocument(boundedRead(path), path, window);
}

std::optional<AskedDocument> askedDocument(const std::variant<QByteArray, ReadError>& bytes, const QString& path,
                                           QWidget* window) {
    std::variant<LoadedFile, OpenError> loaded = documentFrom(bytes);
    if (const OpenError* error = std::get_if<OpenError>(&loaded)) {
        tellNotOpened(errorText(*error, path), window);
        return {};
    }
    LoadedFile& file = std::get<LoadedFile>(loaded);
    const auto answer =
        file.drawn ? askAboutEditedFigure(QFileInfo(path).fileName(), window) : EditedFigureAnswer::Document;
    if (answer == EditedFigureAnswer::Cancel)
        return {};
    return AskedDocument{answer == EditedFigureAnswer::Drawing ? std::move(*file.drawn) : std::move(file.document),
                         contentHash(std::get<QByteArray>(bytes))};
}

} // namespace kriva::ui
