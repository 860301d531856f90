#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"
#include "ui/document/bounded_read.h"

namespace kriva::ui {

/// Why a file could not be opened as a document.
using OpenError = std::variant<ReadError, FileError>;

/// What a file holds.
struct LoadedFile {
    Document document;
    /// Of a figure whose lines were edited elsewhere: the document as they draw it.
    std::optional<Document> drawn = {};
};

/// What was read from a `.kriva` file, or from a figure of Kriva with its document inside.
[[nodiscard]] std::variant<LoadedFile, OpenError> documentFrom(const std::variant<QByteArray, ReadError>& bytes);

} // namespace kriva::ui
