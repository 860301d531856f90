#pragma once

#include "ui/document/document_file.h"

class QWidget;

namespace kriva::ui {

struct AskedDocument {
    Document document;
    QByteArray hash; ///< contentHash() of the file
};

/// The document of a file, or of what was read from it. What is refused is told; where the lines of a figure were
/// edited elsewhere, a person is asked whether the document or the drawing is wanted. Nothing where it is neither.
[[nodiscard]] std::optional<AskedDocument> askedDocument(const QString& path, QWidget* window);
[[nodiscard]] std::optional<AskedDocument> askedDocument(const std::variant<QByteArray, ReadError>& bytes,
                                                         const QString& path, QWidget* window);

} // namespace kriva::ui
