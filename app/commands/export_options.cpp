#include "app/commands/export_options.h"

#include "app/commands/option_number.h"
#include "ui/figures/figure_file.h"
#include "ui/figures/frame_text.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <array>

namespace kriva::app {

using namespace Qt::StringLiterals;

namespace {

constexpr int kMostCurve = 999'999;

struct LengthUnit {
    QLatin1String name;
    double millimetres;
};
constexpr std::array kLengthUnits{LengthUnit{QLatin1String("mm"), 1}, LengthUnit{QLatin1String("cm"), 10},
                                  LengthUnit{QLatin1String("in"), 25.4}, LengthUnit{QLatin1String("pt"), 25.4 / 72}};

/// "120mm", "4.5in"; millimetres where no unit is given.
std::optional<double> lengthOf(QString text) {
    double unit = 1;
    for (const LengthUnit& known : kLengthUnits) {
        if (!text.endsWith(known.name))
            continue;
        text.chop(known.name.size());
        unit = known.millimetres;
        break;
    }
    const std::optional<double> count = optionNumber(text.trimmed(), 0, kMostPageSide / unit);
    return count ? std::optional(*count * unit) : std::nullopt;
}

/// Takes the options one by one; the first that is wrong is told.
class ExportOptionReader {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    explicit ExportOptionReader(const QCommandLineParser& options)
        : options_(options) {}

    [[nodiscard]] std::variant<FigureFileOptions, QString> read() {
        FigureFileOptions result;
        readFormat(result);
        readPage(result.drawing);
        readScale(result.drawing);
        readContent(result.drawing);
        result.holdsDocument = !has(u"no-document"_s);
        result.hasInkscapeLayers = has(u"inkscape-layers"_s);
        result.hasOutlines = has(u"outlines"_s);
        result.isTransparent = has(u"transparent"_s);
        result.tikz = has(u"fragment"_s) ? TikzKind::fragment : TikzKind::standalone;
        result.decimals = number(u"decimals"_s, 0, kMostDecimals);
        readFrames(result);
        result.dpi = number(u"dpi"_s, kLeastDpi, kMostDpi).value_or(kUsualDpi);
        if (!fault_.isEmpty())
            return fault_;
        return result;
    }

  private:
    [[nodiscard]] bool has(const QString& name) const { return options_.isSet(name); }
    void refuse(const QString& sentence) {
        if (fault_.isEmpty())
            fault_ = sentence;
    }
    void readFormat(FigureFileOptions& result) {
        const QString output = options_.value(u"output"_s);
        const QString named = options_.value(u"format"_s);
        const std::optional<FigureFormat> format =
            ui::figureFormatOf(has(u"format"_s) ? QString(u'.' + named) : output);
        if (format)
            result.format = *format;
        else if (has(u"format"_s))
            refuse(tr("there is no format %1").arg(named));
        else
            refuse(tr("%1: figures are written as .svg, .pdf, .png, .tex or .csv").arg(output));
    }
    void readPage(DrawingOptions& drawing) {
        if (const std::optional<double> margin = length(u"margin"_s))
            drawing.margin = *margin;
        drawing.width = length(u"width"_s);
        if (drawing.width && *drawing.width <= 2 * drawing.margin)
            refuse(tr("--width must be more than both margins, which are %1 mm").arg(2 * drawing.margin));
    }
    void readScale(DrawingOptions& drawing) {
        if (!has(u"scale"_s))
            return;
        drawing.mmPerUnit = optionNumber(options_.value(u"scale"_s), kLeastScale, kMostScale);
        if (!drawing.mmPerUnit)
            refuse(tr("--scale is how many millimetres a unit has"));
        else if (has(u"width"_s))
            refuse(tr("--width and --scale do not go together"));
    }
    void readContent(DrawingOptions& drawing) {
        if (const std::optional<int> curve = number(u"curve"_s, 0, kMostCurve))
            drawing.curve = static_cast<std::size_t>(*curve);
        if (has(u"layers"_s)) {
            drawing.layers.emplace();
            for (const QString& layer : options_.value(u"layers"_s).split(u',', Qt::SkipEmptyParts))
                drawing.layers->push_back(layer.trimmed().toStdString());
        }
        drawing.hasLabels = !has(u"no-labels"_s);
        if (!has(u"theme"_s))
            return;
        const QString theme = options_.value(u"theme"_s);
        const auto* named =
            std::ranges::find(kThemeNames, theme.toStdString(), &std::pair<std::string_view, Theme>::first);
        if (named == kThemeNames.end())
            refuse(tr("there is no theme %1").arg(theme));
        else
            drawing.theme = named->second;
    }
    void readFrames(FigureFileOptions& result) {
        const auto frames = ui::readFramePlaces(options_.value(u"frames"_s));
        if (!frames || (has(u"frames"_s) && frames->empty()))
            return refuse(tr("--frames are stages such as 0,5,10 or 0..10, or values such as t=0.25,0.5"));
        result.frames = *frames;
        result.isAnimated = has(u"animate"_s);
        if (result.isAnimated && (result.frames.empty() || result.format != FigureFormat::svg))
            refuse(tr("--animate needs --frames and an SVG file"));
        if (!has(u"seconds"_s))
            return;
        const auto seconds = optionNumber(options_.value(u"seconds"_s), kLeastFrameSeconds, kMostFrameSeconds);
        if (!seconds)
            return refuse(tr("--seconds is a number from %1 to %2").arg(kLeastFrameSeconds).arg(kMostFrameSeconds));
        result.frameSeconds = *seconds;
    }
    std::optional<double> length(const QString& name) {
        if (!has(name))
            return {};
        const std::optional<double> found = lengthOf(options_.value(name));
        if (!found)
            refuse(tr("--%1 is a length such as 120mm, at most %2 mm").arg(name).arg(kMostPageSide));
        return found;
    }
    std::optional<int> number(const QString& name, int low, int high) {
        if (!has(name))
            return {};
        bool isNumber = false;
        const int found = options_.value(name).toInt(&isNumber);
        if (!isNumber || found < low || found > high) {
            refuse(tr("--%1 is a whole number from %2 to %3").arg(name).arg(low).arg(high));
            return {};
        }
        return found;
    }

    const QCommandLineParser& options_;
    QString fault_;
};

} // namespace

QStringList exportOptionNames() {
    return {u"curve="_s,          u"layers="_s,  u"width="_s,      u"scale="_s,   u"margin="_s,   u"dpi="_s,
            u"decimals="_s,       u"theme="_s,   u"frames="_s,     u"seconds="_s, u"no-labels"_s, u"no-document"_s,
            u"inkscape-layers"_s, u"outlines"_s, u"transparent"_s, u"fragment"_s, u"animate"_s};
}

std::variant<FigureFileOptions, QString> exportOptions(const QCommandLineParser& options) {
    return ExportOptionReader(options).read();
}

} // namespace kriva::app
