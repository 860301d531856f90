#pragma once

#include "core/document/document.h"

namespace kriva {

inline constexpr int kReportVersion = 1;

/// The report of a document as JSON, numbers with 17 significant digits; `file` is its name without the folder.
/// With `only`, just that sheet. Refuses documents whose results would be beyond the limits of a report: those that
/// reportLimitError() sees, and curves that meet too often.
[[nodiscard]] std::variant<std::string, FileError> reportJson(const Document& document, std::string_view file,
                                                              std::optional<SheetIndex> only = {});

/// Why a report of the document is refused before anything is worked out; nothing where it is not.
[[nodiscard]] std::optional<FileError> reportLimitError(const Document& document, std::optional<SheetIndex> only = {});

/// The same for the JSON, which lists whole de Casteljau schemes.
[[nodiscard]] std::optional<FileError> reportJsonLimitError(const Document& document,
                                                            std::optional<SheetIndex> only = {});

} // namespace kriva
