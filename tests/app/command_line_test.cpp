#include "app/commands/command_line.h"

#include <gtest/gtest.h>

namespace kriva::app {
namespace {

Request parsed(const char* line) {
    return parseCommandLine(QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

bool isUsageError(const char* line) {
    const Request request = parsed(line);
    const UsageError* error = std::get_if<UsageError>(&request);
    return error != nullptr && !error->sentence.isEmpty();
}

TEST(CommandLine, opensTheEditorWithoutACommand) {
    EXPECT_TRUE(std::get<EditorRequest>(parsed("")).files.isEmpty());
    EXPECT_EQ(std::get<EditorRequest>(parsed("a.kriva --language bg")).files, QStringList(QStringLiteral("a.kriva")));
    EXPECT_EQ(std::get<EditorRequest>(parsed("a.kriva --language bg")).language, ui::Language::Bulgarian);
    EXPECT_EQ(std::get<EditorRequest>(parsed("a.kriva")).language, std::nullopt);
    EXPECT_EQ(std::get<EditorRequest>(parsed("-- -a")).files, QStringList(QStringLiteral("-a")));
}

TEST(CommandLine, understandsExportInAnyOrder) {
    for (const char* line :
         {"export in.kriva -o out.svg --sheet elevation", "export -o out.svg --sheet=elevation in.kriva",
          "--sheet elevation export --output=out.svg in.kriva"}) {
        const ExportRequest request = std::get<ExportRequest>(parsed(line));
        EXPECT_EQ(request.file, QStringLiteral("in.kriva"));
        EXPECT_EQ(request.output, QStringLiteral("out.svg"));
        EXPECT_EQ(request.sheet, SheetIndex(0));
    }
    EXPECT_FALSE(std::get<ExportRequest>(parsed("export in.kriva -o out.SVG")).sheet);
}

TEST(CommandLine, understandsReport) {
    EXPECT_FALSE(std::get<ReportRequest>(parsed("report a.kriva")).isJson);
    EXPECT_TRUE(std::get<ReportRequest>(parsed("report --format json a.kriva")).isJson);
    EXPECT_FALSE(std::get<ReportRequest>(parsed("report --format text a.kriva")).isJson);
}

TEST(CommandLine, answersHelpAndVersionWhateverElseStandsThere) {
    EXPECT_TRUE(std::holds_alternative<HelpRequest>(parsed("export -h")));
    EXPECT_TRUE(std::holds_alternative<VersionRequest>(parsed("--version")));
}

TEST(CommandLine, refusesWhatItDoesNotUnderstand) {
    for (const char* line :
         {"--foo", "-x", "export a.kriva", "export -o b.svg", "export a b -o c.svg", "export a -o b.txt", "export a -o",
          "report", "report a b", "report a --format xml", "report a --sheet plane", "report a --language xx",
          "report a -o b.svg", "export a -o b.svg --format json", "a.kriva --sheet spline", "--help=now"})
        EXPECT_TRUE(isUsageError(line)) << line;
}

TEST(CommandLine, findsTheLanguageBeforeAnythingIsSaid) {
    EXPECT_EQ(languageAskedFor({QStringLiteral("--language=sl"), QStringLiteral("--foo")}), ui::Language::Slovenian);
    EXPECT_EQ(languageAskedFor({QStringLiteral("report"), QStringLiteral("--language"), QStringLiteral("uk")}),
              ui::Language::Ukrainian);
}

} // namespace
} // namespace kriva::app
