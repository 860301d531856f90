#include "app/commands/command_line.h"

#include "app/commands/export_options.h"
#include "app/commands/option_number.h"
#include "core/curve/limits.h"

#include <QCoreApplication>
#include <QMap>

namespace kriva::app {

using namespace Qt::StringLiterals;

namespace {

/// Arguments sorted into words and options; thrown apart before any of them is understood.
struct Words {
    QStringList plain;
    QMap<QString, QString> options; ///< by long name, with their values
    QString fault;                  ///< a sentence; empty where there is none
};

class CommandLine {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    [[nodiscard]] static Words sorted(const QStringList& arguments);
    [[nodiscard]] static Request understood(Words words);
    [[nodiscard]] static QString help();

  private:
    [[nodiscard]] static Request exported(const Words& words);
    [[nodiscard]] static Request imported(const Words& words);
    [[nodiscard]] static Request reported(const Words& words);
    [[nodiscard]] static QString faultOf(const Words& words);
    [[nodiscard]] static QString faultOfOptions(const Words& words, const QStringList& allowed);
};

bool takesValue(const QString& option) {
    return QStringList{u"output"_s, u"sheet"_s, u"format"_s, u"language"_s, u"offset"_s}.contains(option) ||
           exportOptionNames().values.contains(option);
}

bool isKnown(const QString& option) {
    return takesValue(option) || option == u"help" || option == u"version" ||
           exportOptionNames().flags.contains(option);
}

/// "--sheet" and "--sheet=spline" are "sheet", "-o" is "output".
QString longName(const QString& argument) {
    if (argument.startsWith(u"--"))
        return argument.sliced(2).section(u'=', 0, 0);
    const QMap<QString, QString> shortNames{{u"-o"_s, u"output"_s}, {u"-h"_s, u"help"_s}, {u"-v"_s, u"version"_s}};
    return shortNames.value(argument, argument);
}

std::optional<SheetIndex> sheetOf(const Words& words) {
    return sheetNamed(words.options.value(u"sheet"_s).toStdString());
}

/// "elevation, subdivision, spline, combined"
QString sheetNames() {
    QStringList names;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        names += QLatin1StringView(sheetName(sheet).data(), static_cast<qsizetype>(sheetName(sheet).size()));
    return names.join(u", "_s);
}

Words CommandLine::sorted(const QStringList& arguments) {
    Words words;
    for (qsizetype i = 0; i < arguments.size() && words.fault.isEmpty(); ++i) {
        const QString& argument = arguments[i];
        if (argument == u"--") {
            words.plain += arguments.sliced(i + 1);
            break;
        }
        if (!argument.startsWith(u'-') || argument.size() == 1) {
            words.plain += argument;
            continue;
        }
        const QString option = longName(argument);
        const bool holdsValue = argument.startsWith(u"--") && argument.contains(u'=');
        if (!isKnown(option) || (holdsValue && !takesValue(option)))
            words.fault = tr("unknown option %1").arg(argument);
        else if (holdsValue)
            words.options.insert(option, argument.section(u'=', 1));
        else if (!takesValue(option))
            words.options.insert(option, QString());
        else if (i + 1 == arguments.size())
            words.fault = tr("a value is missing behind %1").arg(argument);
        else
            words.options.insert(option, arguments[++i]);
    }
    return words;
}

QString CommandLine::faultOf(const Words& words) {
    if (!words.fault.isEmpty())
        return words.fault;
    const QString language = words.options.value(u"language"_s, u"en"_s);
    if (!ui::languageOf(language))
        return tr("unknown language %1").arg(language);
    if (words.options.contains(u"sheet"_s) && !sheetOf(words))
        return tr("there is no sheet %1").arg(words.options.value(u"sheet"_s));
    return {};
}

QString CommandLine::faultOfOptions(const Words& words, const QStringList& allowed) {
    for (auto option = words.options.keyBegin(); option != words.options.keyEnd(); ++option)
        if (*option != u"language" && !allowed.contains(*option))
            return tr("the option --%1 does not belong here").arg(*option);
    return {};
}

Request CommandLine::exported(const Words& words) {
    const ExportOptionNames own = exportOptionNames();
    if (const QString fault =
            faultOfOptions(words, own.values + own.flags + QStringList{u"output"_s, u"sheet"_s, u"format"_s});
        !fault.isEmpty())
        return UsageError{fault};
    if (words.plain.isEmpty())
        return UsageError{tr("export needs a file")};
    const QString output = words.options.value(u"output"_s);
    if (output.isEmpty())
        return UsageError{tr("export needs the file to write: -o OUT.svg")};
    if (words.plain.size() > 1 && !output.contains(u"{name}"))
        return UsageError{tr("%1: with several files it needs {name} for the name of each").arg(output)};
    std::variant<FigureFileOptions, QString> options = exportOptions(words.options);
    if (QString* fault = std::get_if<QString>(&options))
        return UsageError{std::move(*fault)};
    return ExportRequest{words.plain, output, sheetOf(words), std::get<FigureFileOptions>(std::move(options))};
}

Request CommandLine::imported(const Words& words) {
    const auto numberOf = [](const QString& text) { return optionNumber(text, -limits::kNumber, limits::kNumber); };
    if (const QString fault = faultOfOptions(words, {u"output"_s, u"sheet"_s, u"scale"_s, u"offset"_s});
        !fault.isEmpty())
        return UsageError{fault};
    if (words.plain.isEmpty())
        return UsageError{tr("import needs a file")};
    ImportRequest request{words.plain, words.options.value(u"output"_s), 0, {}};
    if (request.output.isEmpty())
        return UsageError{tr("import needs the document to write: -o OUT.kriva")};
    const std::optional<SheetIndex> sheet = sheetOf(words);
    if (!sheet)
        return UsageError{tr("import needs the sheet that the curves go to: --sheet NAME")};
    request.sheet = *sheet;
    const QString scale = words.options.value(u"scale"_s, u"1"_s);
    const QStringList offset = words.options.value(u"offset"_s, u"0,0"_s).split(u',');
    const std::optional<double> factor = numberOf(scale);
    if (!factor || *factor == 0)
        return UsageError{tr("there is no scale %1").arg(scale)};
    const std::optional<double> x = numberOf(offset.value(0));
    const std::optional<double> y = numberOf(offset.value(1));
    if (offset.size() != 2 || !x || !y)
        return UsageError{tr("%1 is no offset: two numbers with a comma between them").arg(offset.join(u','))};
    request.placing = {*factor, {*x, *y}};
    return request;
}

Request CommandLine::reported(const Words& words) {
    if (const QString fault = faultOfOptions(words, {u"format"_s, u"sheet"_s}); !fault.isEmpty())
        return UsageError{fault};
    if (words.plain.size() != 1)
        return UsageError{tr("report needs one file")};
    const QString format = words.options.value(u"format"_s, u"text"_s);
    if (format != u"json" && format != u"text")
        return UsageError{tr("there is no format %1").arg(format)};
    return ReportRequest{words.plain.first(), format == u"json", sheetOf(words)};
}

Request CommandLine::understood(Words words) {
    if (words.options.contains(u"help"_s))
        return HelpRequest{};
    if (words.options.contains(u"version"_s))
        return VersionRequest{};
    if (const QString fault = faultOf(words); !fault.isEmpty())
        return UsageError{fault};
    const QString command = words.plain.value(0);
    if (command == u"export" || command == u"import" || command == u"report") {
        words.plain.removeFirst();
        return command == u"export" ? exported(words) : command == u"import" ? imported(words) : reported(words);
    }
    if (const QString fault = faultOfOptions(words, {}); !fault.isEmpty())
        return UsageError{fault};
    return EditorRequest{words.plain, ui::languageOf(words.options.value(u"language"_s))};
}

QString CommandLine::help() {
    return tr("kriva [FILE...]\n"
              "    opens the editor\n"
              "kriva export FILE... -o OUT.{svg,pdf,png,tex,csv} [--sheet NAME] [--curve N] [--layers A,B]\n"
              "    draws a sheet: the one named, else the one that was shown when the document was saved.\n"
              "    {name} and {sheet} in OUT stand for those of each file; - is the standard input and output\n"
              "    --format svg|pdf|png|tex|csv     where the end of OUT does not say it\n"
              "    --width 120mm --margin 6mm       of the page; mm, cm, in or pt\n"
              "    --scale 10                       millimetres for a unit, in place of a width\n"
              "    --no-labels --theme light|dark\n"
              "    --no-document --decimals N --inkscape-layers --outlines    of SVG; outlines in place of letters\n"
              "    --dpi 300 --transparent          of PNG\n"
              "    --fragment                       of TeX: to be put into another document\n"
              "    --frames 0,5,10 | 0..10 | t=0.25,0.5   stages of the animation side by side, or with {frame} in "
              "OUT\n"
              "                                     a file for each; --animate --seconds 0.5: one after the other in "
              "SVG\n"
              "kriva import FILE... -o OUT.kriva --sheet NAME [--scale N] [--offset X,Y]\n"
              "    makes a document of the paths of SVG files, of path data or of tables of points\n"
              "kriva report FILE [--format json|text] [--sheet NAME]\n"
              "    prints the numbers of a document\n"
              "\n"
              "    --language CODE   en, bg, sl or uk; else the language of the system\n"
              "    --sheet NAME      %1\n"
              "    --help            this text\n"
              "    --version         the version\n"
              "\n"
              "Exit codes: 0 done, 1 failure, 2 wrong usage, 3 input refused, 4 output not written.\n")
        .arg(sheetNames());
}

} // namespace

Request parseCommandLine(const QStringList& arguments) {
    return CommandLine::understood(CommandLine::sorted(arguments));
}

ui::Language languageAskedFor(const QStringList& arguments) {
    const QString code = CommandLine::sorted(arguments).options.value(u"language"_s);
    return ui::languageOf(code).value_or(ui::systemLanguage());
}

QString helpText() {
    return CommandLine::help();
}

} // namespace kriva::app
