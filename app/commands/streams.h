#pragma once

#include "app/commands/terminal.h"
#include "core/document/document.h"

#include <QString>

namespace kriva::app {

/// Whether a name stands for the standard input or output: `-`.
[[nodiscard]] bool isStandardStream(const QString& file);

/// All bytes of a file or of the standard input.
[[nodiscard]] std::variant<QByteArray, ui::ReadError> readInput(const QString& file);

/// The document of a file or of the standard input; tells what went wrong, and where the lines of a figure are not the
/// document's any more.
[[nodiscard]] std::optional<Document> openDocument(const QString& file);

/// Into a file, safely, or to the standard output; tells what went wrong.
[[nodiscard]] ExitCode writeOutput(const QString& file, const QByteArray& bytes);

} // namespace kriva::app
