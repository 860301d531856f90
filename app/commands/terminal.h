#pragma once

#include "ui/document/bounded_read.h"

namespace kriva::app {

enum class ExitCode { done = 0, failure = 1, usage = 2, refused = 3, notWritten = 4 };

/// One line on stderr, printable(), of at most 1,000 characters.
void printError(const QString& line);

/// All bytes of stdin, at most as many as a file may have.
[[nodiscard]] std::variant<QByteArray, ui::ReadError> readIn();

/// Writes to stdout; notWritten (with a line on stderr) where not every byte got there.
[[nodiscard]] ExitCode printOut(const QByteArray& bytes);

/// From now on what Qt has to say is one such line each.
void logToTerminal();

/// While the application of the editor is made, Qt aborts if no display can be reached; with this the process prints
/// the sentence and ends with ExitCode::failure instead. Until logToTerminal() Qt says nothing else.
void endWithoutDisplay(const QString& sentence);

} // namespace kriva::app
