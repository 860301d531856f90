#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"
#include "ui/document/bounded_read.h"
#include "ui/document/safe_write.h"

namespace kriva::ui {

/// Why a file could not be opened as a document.
using OpenError = std::variant<ReadError, FileError>;

/// What a file holds.
struct LoadedFile {
    Document document;
    /// Of a figure whose lines were edited elsewhere: the document as they draw it.
    std::optional<Document> drawn = {};
};

/// Reads a `.kriva` file, or a figure of Kriva with its document inside.
[[nodiscard]] std::variant<LoadedFile, OpenError> loadDocument(const QString& path);

/// The same from what was read already.
[[nodiscard]] std::variant<LoadedFile, OpenError> documentFrom(const std::variant<QByteArray, ReadError>& bytes);

/// Writes the document; nothing on success.
[[nodiscard]] std::optional<WriteError> saveDocument(const QString& path, const Document& document);

} // namespace kriva::ui
