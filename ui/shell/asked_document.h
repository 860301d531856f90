#pragma once

#include "core/document/document.h"

#include <QByteArray>
#include <QString>

class QWidget;

namespace kriva::ui {

struct AskedDocument {
    Document document;
    QByteArray hash; ///< contentHash() of the file
};

/// The document of a file. What is refused is told; where the lines of a figure were edited elsewhere, a person is
/// asked whether the document or the drawing is wanted. Nothing where it is neither.
[[nodiscard]] std::optional<AskedDocument> askedDocument(const QString& path, QWidget* window);

} // namespace kriva::ui
