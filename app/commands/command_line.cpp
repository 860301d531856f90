#include "app/commands/command_line.h"

#include "app/commands/export_options.h"
#include "app/commands/option_number.h"
#include "core/curve/limits.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace kriva::app {

using namespace Qt::StringLiterals;

namespace {

/// By their long names, with an equals sign where a value follows.
QStringList optionsOf(const QString& command) {
    QStringList options{u"language="_s, u"help"_s, u"version"_s};
    if (command == u"export")
        options += exportOptionNames() + QStringList{u"output="_s, u"sheet="_s, u"format="_s};
    else if (command == u"import")
        options += {u"output="_s, u"sheet="_s, u"scale="_s, u"offset="_s};
    else if (command == u"report")
        options += {u"format="_s, u"sheet="_s};
    return options;
}

QStringList allOptions() {
    QStringList all = optionsOf(u"export"_s) + optionsOf(u"import"_s) + optionsOf(u"report"_s);
    all.removeDuplicates();
    return all;
}

/// "elevation, subdivision, spline, combined"
QString sheetNames() {
    QStringList names;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        names += QLatin1StringView(sheetName(sheet).data(), static_cast<qsizetype>(sheetName(sheet).size()));
    return names.join(u", "_s);
}

class CommandLine {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    explicit CommandLine(const QStringList& arguments);

    [[nodiscard]] Request request() const;
    [[nodiscard]] std::optional<ui::Language> language() const { return ui::languageOf(value(u"language"_s)); }
    [[nodiscard]] static QString help();

  private:
    [[nodiscard]] Request exported() const;
    [[nodiscard]] Request imported() const;
    [[nodiscard]] Request reported() const;
    // What is wrong with the options, each in a sentence that is empty where nothing is.
    [[nodiscard]] QString flagWithValue() const;
    [[nodiscard]] QString fault() const;
    [[nodiscard]] QString strayOption(const QString& command) const;
    [[nodiscard]] bool has(const QString& option) const { return options_.isSet(option); }
    [[nodiscard]] QString value(const QString& option) const { return options_.value(option); }
    [[nodiscard]] std::optional<SheetIndex> sheet() const { return sheetNamed(value(u"sheet"_s).toStdString()); }

    const QStringList arguments_;
    QCommandLineParser options_;
    bool isWellFormed_ = false;
    QStringList plain_; ///< what is no option
};

CommandLine::CommandLine(const QStringList& arguments)
    : arguments_(arguments) {
    for (const QString& option : allOptions()) {
        const QString name = option.section(u'=', 0, 0);
        const bool hasLetter = name == u"output" || name == u"help" || name == u"version";
        options_.addOption(
            {hasLetter ? QStringList{name.first(1), name} : QStringList{name}, {}, option == name ? QString() : name});
    }
    isWellFormed_ = options_.parse(QStringList(QString()) + arguments);
    plain_ = options_.positionalArguments();
}

QString CommandLine::flagWithValue() const {
    for (const QString& argument : arguments_)
        if (!isWellFormed_ && argument.contains(u'=') && allOptions().contains(argument.section(u'=', 0, 0).mid(2)))
            return tr("unknown option %1").arg(argument);
    return {};
}

QString CommandLine::fault() const {
    if (const QStringList unknown = options_.unknownOptionNames(); !unknown.isEmpty())
        return tr("unknown option %1").arg((unknown.first().size() == 1 ? u"-"_s : u"--"_s) + unknown.first());
    if (!isWellFormed_)
        return tr("a value is missing behind %1").arg(arguments_.constLast());
    if (has(u"language"_s) && !language())
        return tr("unknown language %1").arg(value(u"language"_s));
    if (has(u"sheet"_s) && !sheet())
        return tr("there is no sheet %1").arg(value(u"sheet"_s));
    return {};
}

QString CommandLine::strayOption(const QString& command) const {
    const QStringList allowed = optionsOf(command);
    for (const QString& option : allOptions())
        if (const QString name = option.section(u'=', 0, 0); has(name) && !allowed.contains(option))
            return tr("the option --%1 does not belong here").arg(name);
    return {};
}

Request CommandLine::exported() const {
    const QStringList files = plain_.sliced(1);
    if (files.isEmpty())
        return UsageError{tr("export needs a file")};
    const QString output = value(u"output"_s);
    if (output.isEmpty())
        return UsageError{tr("export needs the file to write: -o OUT.svg")};
    if (files.size() > 1 && !output.contains(u"{name}"))
        return UsageError{tr("%1: with several files it needs {name} for the name of each").arg(output)};
    std::variant<FigureFileOptions, QString> options = exportOptions(options_);
    if (QString* fault = std::get_if<QString>(&options))
        return UsageError{std::move(*fault)};
    return ExportRequest{files, output, sheet(), std::get<FigureFileOptions>(std::move(options))};
}

Request CommandLine::imported() const {
    const auto numberOf = [](const QString& text) { return optionNumber(text, -limits::kNumber, limits::kNumber); };
    ImportRequest request{plain_.sliced(1), value(u"output"_s), sheet().value_or(0), {}};
    if (request.files.isEmpty())
        return UsageError{tr("import needs a file")};
    if (request.output.isEmpty())
        return UsageError{tr("import needs the document to write: -o OUT.kriva")};
    if (!sheet())
        return UsageError{tr("import needs the sheet that the curves go to: --sheet NAME")};
    const QString scale = has(u"scale"_s) ? value(u"scale"_s) : u"1"_s;
    const QStringList offset = (has(u"offset"_s) ? value(u"offset"_s) : u"0,0"_s).split(u',');
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

Request CommandLine::reported() const {
    if (plain_.size() != 2)
        return UsageError{tr("report needs one file")};
    const QString format = value(u"format"_s);
    if (has(u"format"_s) && format != u"json" && format != u"text")
        return UsageError{tr("there is no format %1").arg(format)};
    return ReportRequest{plain_.last(), format == u"json", sheet()};
}

Request CommandLine::request() const {
    if (const QString flag = flagWithValue(); !flag.isEmpty())
        return UsageError{flag};
    if (has(u"help"_s))
        return HelpRequest{};
    if (has(u"version"_s))
        return VersionRequest{};
    if (const QString wrong = fault(); !wrong.isEmpty())
        return UsageError{wrong};
    const QString command = plain_.value(0);
    if (const QString stray = strayOption(command); !stray.isEmpty())
        return UsageError{stray};
    if (command == u"export")
        return exported();
    if (command == u"import")
        return imported();
    if (command == u"report")
        return reported();
    return EditorRequest{plain_, language()};
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
    return CommandLine(arguments).request();
}

ui::Language languageAskedFor(const QStringList& arguments) {
    return CommandLine(arguments).language().value_or(ui::systemLanguage());
}

QString helpText() {
    return CommandLine::help();
}

} // namespace kriva::app
