#pragma once

#include "app/commands/terminal.h"

#include <QString>

namespace kriva::app {

/// Whether a name stands for the standard input or output: `-`.
[[nodiscard]] bool isStandardStream(const QString& file);

/// All bytes of a file or of the standard input.
[[nodiscard]] std::variant<QByteArray, ui::ReadError> readInput(const QString& file);

/// Into a file, safely, or to the standard output; tells what went wrong.
[[nodiscard]] ExitCode writeOutput(const QString& file, const QByteArray& bytes);

} // namespace kriva::app
