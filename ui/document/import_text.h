#pragma once

#include "core/io/imported_text.h"

#include <QByteArray>
#include <QString>

namespace kriva::ui {

/// readImportedText() with one line, in the present language, that says why not, and where in the text.
[[nodiscard]] std::variant<std::vector<ImportedPath>, QString> readImport(const QByteArray& text);

} // namespace kriva::ui
