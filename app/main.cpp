#include "app/commands/command_line.h"
#include "app/commands/export_command.h"
#include "app/commands/import_command.h"
#include "app/commands/report_command.h"
#include "app/editor.h"

#include <QApplication>
#include <QHashSeed>

#include <algorithm>
#include <fontconfig/fontconfig.h>
#include <memory>
#include <string_view>
#include <thread>

namespace kriva::app {
namespace {

class Program {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString noDisplay() { return tr("the editor needs a display; export and report do without one"); }
    static QString seeHelp(const QString& fault) { return tr("%1; kriva --help tells more").arg(fault); }
};

/// What the command line asks for, done; nothing where it asks for the editor.
struct Answer {
    ExitCode operator()(const HelpRequest&) const { return printOut(helpText().toUtf8()); }
    ExitCode operator()(const VersionRequest&) const {
        return printOut(QStringLiteral("kriva %1\n").arg(QCoreApplication::applicationVersion()).toUtf8());
    }
    ExitCode operator()(const UsageError& error) const {
        printError(Program::seeHelp(error.sentence));
        return ExitCode::usage;
    }
    ExitCode operator()(const ExportRequest& request) const { return exportFigures(request); }
    ExitCode operator()(const ImportRequest& request) const { return importFiles(request); }
    ExitCode operator()(const ReportRequest& request) const { return report(request); }
    std::optional<ExitCode> operator()(const EditorRequest&) const { return std::nullopt; }
};

constexpr const char* kPlatform = "QT_QPA_PLATFORM";

/// Pictures need fonts, which come with a platform; the one without a display is always there.
std::unique_ptr<QCoreApplication> applicationFor(int& argc, char** argv) {
    const bool mayPaint = std::any_of(argv, argv + argc, [](std::string_view word) { return word == "export"; });
    if (!mayPaint)
        return std::make_unique<QCoreApplication>(argc, argv);
    const QByteArray platform = qgetenv(kPlatform);
    qputenv(kPlatform, "offscreen");
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    platform.isNull() ? qunsetenv(kPlatform) : qputenv(kPlatform, platform); // for an editor on a file of this name
    return application;
}

/// Everything but the editor, which needs another kind of application: what came of it, and for the editor the
/// sentence for want of a display in the language asked for.
std::optional<ExitCode> runCommand(int argc, char** argv, EditorRequest& editor) {
    endWithoutDisplay({}); // and nothing of Qt's own about the locale
    const std::unique_ptr<QCoreApplication> application = applicationFor(argc, argv);
    logToTerminal();
    const QStringList arguments = QCoreApplication::arguments().sliced(1);
    const ui::LanguageSwitch language(languageAskedFor(arguments));
    const Request request = parseCommandLine(arguments);
    if (const EditorRequest* asked = std::get_if<EditorRequest>(&request)) {
        editor = *asked;
        endWithoutDisplay(Program::noDisplay());
    }
    return std::visit([](const auto& r) { return std::optional<ExitCode>(Answer()(r)); }, request);
}

} // namespace
} // namespace kriva::app

int main(int argc, char** argv) {
    using namespace kriva::app;
    QHashSeed::setDeterministicGlobalSeed(); // so that two exports of one figure are the same bytes
    QCoreApplication::setApplicationName(QStringLiteral("kriva"));
    QCoreApplication::setApplicationVersion(QStringLiteral(KRIVA_VERSION));
    EditorRequest editor;
    if (const std::optional<ExitCode> code = runCommand(argc, argv, editor))
        return static_cast<int>(*code);
    // Reading the system's list of fonts takes as long as meeting the display: both at once. Qt finds it read.
    std::thread fonts([] { FcInit(); });
    QApplication application(argc, argv);
    fonts.join();
    logToTerminal();
    return kriva::runEditor({editor.files, editor.language});
}
