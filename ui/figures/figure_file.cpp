#include "ui/figures/figure_file.h"

#include "core/io/points_csv.h"
#include "core/io/svg/svg_writer.h"
#include "ui/figures/caption_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace kriva::ui {
namespace {

constexpr std::array<std::pair<const char*, FigureFormat>, 5> kFormats{{{".svg", FigureFormat::svg},
                                                                        {".pdf", FigureFormat::pdf},
                                                                        {".png", FigureFormat::png},
                                                                        {".tex", FigureFormat::tikz},
                                                                        {".csv", FigureFormat::csv}}};

class FaultTexts {
    Q_DECLARE_TR_FUNCTIONS(FigureFile)
};

SvgOptions svgOptions(const FigureFileOptions& options) {
    return {{}, options.decimals, options.hasInkscapeLayers};
}

QByteArray bytesOf(const std::string& text) {
    return QByteArray::fromStdString(text);
}

} // namespace

std::optional<FigureFormat> figureFormatOf(const QString& path) {
    for (const auto& [suffix, format] : kFormats)
        if (path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive))
            return format;
    return {};
}

QString suffixOf(FigureFormat format) {
    const auto* found = std::ranges::find(kFormats, format, &std::pair<const char*, FigureFormat>::second);
    return QLatin1String(found->first);
}

QString faultText(FigureFault fault) {
    if (fault == FigureFault::tooManyPixels)
        return FaultTexts::tr("the picture would have more than %1 pixels a side").arg(kMostPixels);
    return FaultTexts::tr("TeX draws at most %1 mm a side; give the figure a width").arg(kMostTexSide);
}

FigureFile drawingFile(const Drawing& drawing, const FigureFileOptions& options) {
    const TextSource texts = textSource();
    switch (options.format) {
    case FigureFormat::pdf:
        return writePdf(drawing, texts);
    case FigureFormat::tikz:
        if (std::max(drawing.page.width, drawing.page.height) > kMostTexSide)
            return FigureFault::beyondTex;
        return bytesOf(writeTikz(drawing, texts, options.tikz));
    case FigureFormat::png: {
        const QSize pixels = pixelSize(drawing.page, options.dpi);
        if (std::max(pixels.width(), pixels.height()) > kMostPixels)
            return FigureFault::tooManyPixels;
        Drawing onPaper = drawing;
        onPaper.hasPaper = !options.isTransparent;
        return writePng(onPaper, texts, options.dpi);
    }
    case FigureFormat::svg:
    case FigureFormat::csv:
        break;
    }
    return bytesOf(writeSvg(drawing, texts, svgOptions(options)));
}

FigureFile figureFile(const Document& document, SheetIndex sheet, const FigureFileOptions& options) {
    const TextSource texts = textSource();
    if (options.format == FigureFormat::csv)
        return bytesOf(writePointsCsv(document.sheets[sheet], options.drawing.curve));
    if (options.format == FigureFormat::svg && options.holdsDocument)
        return bytesOf(writeSheetSvg(document, sheet, texts, options.drawing, svgOptions(options)));
    return drawingFile(drawingOf(document, sheet, texts, options.drawing), options);
}

} // namespace kriva::ui
