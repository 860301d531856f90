#pragma once

#include "core/io/json/document_json.h"
#include "ui/document/document_file.h"
#include "ui/document/safe_write.h"

namespace kriva::test {

inline std::variant<ui::LoadedFile, ui::OpenError> loadDocument(const QString& path) {
    return ui::documentFrom(ui::boundedRead(path));
}

inline std::optional<ui::WriteError> saveDocument(const QString& path, const Document& document) {
    return ui::safeWrite(path, QByteArray::fromStdString(writeDocument(document)));
}

} // namespace kriva::test
