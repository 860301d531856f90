#include "app/commands/command_line.h"
#include "tests/support/sheet_curves.h"

#include <gtest/gtest.h>

namespace kriva::app {
namespace {

Request parsed(const char* line) {
    return parseCommandLine(QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

/// Why a line is refused; empty where it is not.
QString refusal(const char* line) {
    const Request request = parsed(line);
    const UsageError* error = std::get_if<UsageError>(&request);
    return error ? error->sentence : QString();
}

bool isUsageError(const char* line) {
    return !refusal(line).isEmpty();
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
        EXPECT_EQ(request.files, QStringList(QStringLiteral("in.kriva")));
        EXPECT_EQ(request.output, QStringLiteral("out.svg"));
        EXPECT_EQ(request.sheet, test::kElevation);
    }
    EXPECT_FALSE(std::get<ExportRequest>(parsed("export in.kriva -o out.SVG")).sheet);
}

TEST(CommandLine, knowsTheFormatByTheFileOrByItsName) {
    const auto formatOf = [](const char* line) { return std::get<ExportRequest>(parsed(line)).options.format; };
    EXPECT_EQ(formatOf("export a -o b.PDF"), FigureFormat::pdf);
    EXPECT_EQ(formatOf("export a -o b.png"), FigureFormat::png);
    EXPECT_EQ(formatOf("export a -o b.tex"), FigureFormat::tikz);
    EXPECT_EQ(formatOf("export a -o b.csv"), FigureFormat::csv);
    EXPECT_EQ(formatOf("export - -o - --format tex"), FigureFormat::tikz);
}

TEST(CommandLine, understandsHowAFigureIsToLook) {
    const ExportRequest request = std::get<ExportRequest>(
        parsed("export a b -o {name}.svg --width 12cm --margin=0.5in --layers curve,labels --curve 2 --no-labels "
               "--theme dark --decimals 3 --dpi 150 --transparent --fragment --inkscape-layers --no-document"));
    const FigureFileOptions& options = request.options;
    EXPECT_EQ(request.files.size(), 2);
    EXPECT_EQ(options.drawing.width, 120);
    EXPECT_DOUBLE_EQ(options.drawing.margin, 12.7);
    EXPECT_EQ(options.drawing.layers, (std::vector<std::string>{"curve", "labels"}));
    EXPECT_EQ(options.drawing.curve, std::size_t(2));
    EXPECT_FALSE(options.drawing.hasLabels);
    EXPECT_EQ(options.drawing.theme, Theme::dark);
    EXPECT_EQ(options.decimals, 3);
    EXPECT_EQ(options.dpi, 150);
    EXPECT_TRUE(options.isTransparent && options.hasInkscapeLayers && !options.holdsDocument);
    EXPECT_EQ(options.tikz, TikzKind::fragment);
    const FigureFileOptions usual = std::get<ExportRequest>(parsed("export a -o b.svg")).options;
    EXPECT_EQ(usual.drawing.width, std::nullopt);
    EXPECT_EQ(usual.drawing.margin, kPageMargin);
    EXPECT_TRUE(usual.holdsDocument && usual.drawing.hasLabels);
}

TEST(CommandLine, takesAScaleInPlaceOfAWidth) {
    EXPECT_EQ(std::get<ExportRequest>(parsed("export a -o b.svg --scale 2.5")).options.drawing.mmPerUnit, 2.5);
    for (const char* line :
         {"export a -o b.svg --scale 0", "export a -o b.svg --scale x", "export a -o b.svg --scale 2 --width 90mm"})
        EXPECT_TRUE(isUsageError(line)) << line;
}

TEST(CommandLine, understandsFrames) {
    const auto optionsOf = [](const char* line) { return std::get<ExportRequest>(parsed(line)).options; };
    EXPECT_EQ(optionsOf("export a -o b.svg --frames 0..3").frames.size(), 4U);
    EXPECT_EQ(optionsOf("export a -o b.svg --frames=t=0.5").frames.front(), (FramePlace{FramePlace::Over::t, 0.5}));
    EXPECT_TRUE(optionsOf("export a -o b.svg --frames 1,2 --animate").isAnimated);
    EXPECT_EQ(optionsOf("export a -o b.svg --frames 1,2 --animate --seconds 0.1").frameSeconds, 0.1);
    EXPECT_TRUE(optionsOf("export a -o b.svg --outlines").hasOutlines);
    for (const char* line : {"export a -o b.svg --frames", "export a -o b.svg --frames x",
                             "export a -o b.svg --animate", "export a -o b.svg --frames 1 --animate --seconds 0"})
        EXPECT_TRUE(isUsageError(line)) << line;
}

TEST(CommandLine, understandsImport) {
    const ImportRequest request =
        std::get<ImportRequest>(parsed("import a.svg - -o b.kriva --sheet combined --scale 0.5 --offset=-1,2.5"));
    EXPECT_EQ(request.files, (QStringList{QStringLiteral("a.svg"), QStringLiteral("-")}));
    EXPECT_EQ(request.output, QStringLiteral("b.kriva"));
    EXPECT_EQ(request.sheet, test::kCombined);
    EXPECT_EQ(request.placing, (Placing{0.5, {-1, 2.5}}));
    EXPECT_EQ(std::get<ImportRequest>(parsed("import a -o b --sheet spline")).placing, Placing());
    for (const char* line : {"import -o b --sheet spline", "import a --sheet spline", "import a -o b",
                             "import a -o b --sheet spline --scale 0", "import a -o b --sheet spline --scale big",
                             "import a -o b --sheet spline --offset 1", "import a -o b --sheet spline --offset 1,2,3",
                             "import a -o b --sheet spline --offset 1,1e10", "import a -o b --sheet spline --dpi 3"})
        EXPECT_TRUE(isUsageError(line)) << line;
}

TEST(CommandLine, understandsReport) {
    EXPECT_FALSE(std::get<ReportRequest>(parsed("report a.kriva")).isJson);
    EXPECT_TRUE(std::get<ReportRequest>(parsed("report --format json a.kriva")).isJson);
    EXPECT_FALSE(std::get<ReportRequest>(parsed("report --format text a.kriva")).isJson);
}

TEST(CommandLine, answersHelpAndVersionWhateverElseStandsThere) {
    EXPECT_TRUE(std::holds_alternative<HelpRequest>(parsed("export -h")));
    EXPECT_TRUE(std::holds_alternative<VersionRequest>(parsed("--version")));
    EXPECT_TRUE(std::holds_alternative<HelpRequest>(parsed("--help --foo")));
    EXPECT_TRUE(std::holds_alternative<HelpRequest>(parsed("--help export -o")));
}

TEST(CommandLine, refusesWhatItDoesNotUnderstand) {
    for (const char* line : {"--foo",
                             "-x",
                             "export a.kriva",
                             "export -o b.svg",
                             "export a b -o c.svg",
                             "export a -o b.txt",
                             "export a -o",
                             "report",
                             "report a b",
                             "report a --format xml",
                             "report a --sheet plane",
                             "report a --language xx",
                             "report a -o b.svg",
                             "export a -o b.svg --format json",
                             "export a -o -",
                             "export a -o b.svg --width 12mm",
                             "export a -o b.svg --width wide",
                             "export a -o b.svg --width -5mm",
                             "export a -o b.svg --curve -1",
                             "export a -o b.svg --dpi 9",
                             "export a -o b.svg --theme red",
                             "report a --width 100mm",
                             "a.kriva --sheet spline",
                             "--help=now"})
        EXPECT_TRUE(isUsageError(line)) << line;
}

TEST(CommandLine, saysWhichOptionIsWrong) {
    EXPECT_EQ(refusal("report a --foo"), QStringLiteral("unknown option --foo"));
    EXPECT_EQ(refusal("-x"), QStringLiteral("unknown option -x"));
    EXPECT_EQ(refusal("--help=now --version"), QStringLiteral("unknown option --help=now"));
    EXPECT_EQ(refusal("export a -o"), QStringLiteral("a value is missing behind -o"));
    EXPECT_EQ(refusal("export a -o b.svg --outlines --dpi"), QStringLiteral("a value is missing behind --dpi"));
    EXPECT_EQ(refusal("report a -o b.svg"), QStringLiteral("the option --output does not belong here"));
    EXPECT_EQ(refusal("a.kriva --outlines"), QStringLiteral("the option --outlines does not belong here"));
    EXPECT_EQ(refusal("report a --sheet=x=y"), QStringLiteral("there is no sheet x=y"));
}

TEST(CommandLine, findsTheLanguageBeforeAnythingIsSaid) {
    EXPECT_EQ(languageAskedFor({QStringLiteral("--language=sl"), QStringLiteral("--foo")}), ui::Language::Slovenian);
    EXPECT_EQ(languageAskedFor({QStringLiteral("report"), QStringLiteral("--language"), QStringLiteral("uk")}),
              ui::Language::Ukrainian);
}

} // namespace
} // namespace kriva::app
