#pragma once

#include "ui/document/document_file.h"
#include "ui/document/safe_write.h"

#include <QString>

namespace kriva::ui {

/// One line that names the place and says what was expected there, in the present language.
[[nodiscard]] QString errorText(const FileError& error);

/// The same without the place, where it says nothing to a person.
[[nodiscard]] QString reasonText(const FileError& error);

/// One line about a file that could not be read, opened or written.
[[nodiscard]] QString errorText(const ReadError& error, const QString& path);
[[nodiscard]] QString errorText(const OpenError& error, const QString& path);
[[nodiscard]] QString errorText(const WriteError& error, const QString& path);

/// One line about a file that was written, but could not be given the rights of the old one: keptRights().
[[nodiscard]] QString lostRightsText(const QString& path);

} // namespace kriva::ui
