#pragma once

#include "core/document/document.h"
#include "core/figure/style/figure_options.h"
#include "core/io/svg/imported.h"
#include "ui/base/language/language.h"

#include <QStringList>

#include <optional>
#include <variant>

namespace kriva::app {

struct EditorRequest {
    QStringList files;
    std::optional<ui::Language> language; ///< else the one that was chosen last
};
struct ExportRequest {
    QStringList files;
    QString output; ///< `{name}` and `{sheet}` stand for those of each file
    std::optional<SheetIndex> sheet;
    FigureFileOptions options;
};
struct ImportRequest {
    QStringList files;
    QString output;
    SheetIndex sheet = 0;
    Placing placing;
};
struct ReportRequest {
    QString file;
    bool isJson = false;
    std::optional<SheetIndex> sheet;
};
struct HelpRequest {};
struct VersionRequest {};
struct UsageError {
    QString sentence;
};

using Request =
    std::variant<EditorRequest, ExportRequest, ImportRequest, ReportRequest, HelpRequest, VersionRequest, UsageError>;

/// What is asked for; `arguments` begin behind the name of the program. Sentences are in the present language.
[[nodiscard]] Request parseCommandLine(const QStringList& arguments);

/// The language of `--language`, which is looked for before anything is said; that of the system where it is missing
/// or unknown (which parseCommandLine tells).
[[nodiscard]] ui::Language languageAskedFor(const QStringList& arguments);

/// The text of `--help`.
[[nodiscard]] QString helpText();

} // namespace kriva::app
