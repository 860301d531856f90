#include "ui/figures/figure_file.h"

#include "core/io/latex/tikz_writer.h"
#include "core/io/numbers/plain_number.h"
#include "core/io/svg/svg_writer.h"
#include "core/io/tables/points_writer.h"
#include "ui/document/error_text.h"
#include "ui/figures/caption_text.h"
#include "ui/figures/figure_ink.h"
#include "ui/figures/picture_files.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

class FaultTexts {
    Q_DECLARE_TR_FUNCTIONS(FigureFile)
};

/// Of the letters of a label, in millimetres: a letter is some thousand units high, fonts being set in whole ones.
std::string outlineData(const PlacedLabel& label) {
    constexpr double kUnits = 1000; // of a millimetre
    constexpr int kDecimals = 4;
    static const LabelFonts fonts = labelFonts(kUnits * kMillimetresPerPoint);
    const QPainterPath path = labelOutlines(label, {kUnits * label.baseline.x, kUnits * label.baseline.y}, fonts);
    std::string data;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element element = path.elementAt(i);
        if (element.isMoveTo())
            data += data.empty() ? "M" : " Z M";
        else if (element.isLineTo())
            data += " L";
        else if (element.isCurveTo())
            data += " C";
        data.append(" ").append(plainNumber(element.x / kUnits, kDecimals));
        data.append(",").append(plainNumber(element.y / kUnits, kDecimals));
    }
    return data.empty() ? data : data + " Z";
}

/// What an SVG file is written with; the document goes along where the options say so.
SvgOptions svgOptions(const FigureFileOptions& options, const Document* document) {
    SvgOptions svg{{}, options.decimals, options.hasInkscapeLayers, {}};
    if (document && options.holdsDocument)
        svg.document = documentForSvg(*document);
    if (options.hasOutlines)
        svg.outlineOf = outlineData;
    return svg;
}

QByteArray bytesOf(const std::string& text) {
    return QByteArray::fromStdString(text);
}

} // namespace

std::optional<FigureFormat> figureFormatOf(const QString& path) {
    for (const auto& [name, format] : kFormatNames)
        if (path.endsWith(suffixOf(format), Qt::CaseInsensitive))
            return format;
    return {};
}

QString suffixOf(FigureFormat format) {
    const auto* named = std::ranges::find(kFormatNames, format, &std::pair<std::string_view, FigureFormat>::second);
    return QLatin1Char('.') + QLatin1String(named->first.data(), static_cast<qsizetype>(named->first.size()));
}

QString faultText(FigureFault fault) {
    if (fault == FigureFault::noSuchFrame)
        return FaultTexts::tr("the animation of the curve has no such frame");
    if (fault == FigureFault::tooManyPixels)
        return FaultTexts::tr("the picture would have more than %1 pixels a side").arg(kMostPixels);
    return FaultTexts::tr("TeX draws at most %1 mm a side; give the figure a width").arg(kMostTexSide);
}

QString faultText(const FigureFile& file) {
    if (const FileError* error = std::get_if<FileError>(&file))
        return errorText(*error);
    const FigureFault* fault = std::get_if<FigureFault>(&file);
    return fault ? faultText(*fault) : QString();
}

FigureFile drawingFile(const Drawing& drawing, const FigureFileOptions& options, const Document* document) {
    if (drawing.refusal)
        return *drawing.refusal;
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
        onPaper.hasPaper = hasPaper(options);
        return writePng(onPaper, texts, options.dpi);
    }
    case FigureFormat::svg:
    case FigureFormat::csv:
        break;
    }
    return bytesOf(writeSvg(drawing, texts, svgOptions(options, document)));
}

std::vector<FigureFile> frameFiles(const Document& document, SheetIndex sheet, const FigureFileOptions& options,
                                   WorkBudget& budget) {
    const auto frames = framesOf(document, sheet, options.frames, textSource(), options.drawing, budget);
    if (!frames)
        return {FigureFault::noSuchFrame};
    std::vector<FigureFile> files;
    for (const Drawing& frame : *frames)
        files.push_back(drawingFile(frame, options));
    return files;
}

FigureFile figureFile(const Document& document, SheetIndex sheet, const FigureFileOptions& options,
                      WorkBudget& budget) {
    const TextSource texts = textSource();
    if (options.format == FigureFormat::csv)
        return bytesOf(writePointsCsv(document.sheets[sheet], options.drawing.curve));
    if (options.frames.empty())
        return drawingFile(drawingOf(document, sheet, texts, options.drawing, budget), options, &document);
    if (options.isAnimated && options.format == FigureFormat::svg) {
        const auto frames = framesOf(document, sheet, options.frames, texts, options.drawing, budget);
        if (!frames)
            return FigureFault::noSuchFrame;
        if (frames->front().refusal)
            return *frames->front().refusal;
        return bytesOf(writeAnimatedSvg(*frames, options.frameSeconds, texts, svgOptions(options, &document)));
    }
    const auto strip = frameStripOf(document, sheet, options.frames, texts, options.drawing, budget);
    return strip ? drawingFile(*strip, options, &document) : FigureFault::noSuchFrame;
}

} // namespace kriva::ui
