#include "core/io/drawing/drawing.h"

#include "core/curve/limits.h"
#include "core/document/sheet_figure.h"
#include "core/figure/plot/plot_figure.h"

#include <algorithm>

namespace kriva {
namespace {

std::vector<std::string> titlesOf(const Figure& figure, std::span<const LayerInfo> table, const TextSource& texts) {
    std::vector<std::string> titles;
    for (const Layer& layer : figure.layers) {
        const auto info = std::ranges::find(table, layer.name, &LayerInfo::name);
        titles.push_back(info == table.end() ? std::string(layer.name) : texts.translate(info->caption));
    }
    return titles;
}

/// "Elevation: Control polygon, Curve, Points"
std::string describe(SheetIndex sheet, const std::vector<std::string>& layerTitles, const TextSource& texts) {
    std::string text = texts.translate(captionOf(sheet));
    std::string_view separator = ": ";
    for (const std::string& title : layerTitles) {
        text.append(separator).append(title);
        separator = ", ";
    }
    return text;
}

/// Without its texts where the options say so.
Figure lettered(Figure figure, const DrawingOptions& options) {
    if (!options.hasLabels)
        for (Layer& layer : figure.layers)
            layer.labels.clear();
    return figure;
}

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

/// The sheet with only what the options name on view.
Sheet chosen(Sheet sheet, SheetIndex index, const DrawingOptions& options) {
    if (options.layers)
        for (const LayerInfo& layer : layersOf(index))
            sheet.view.layers[std::string(layer.name)] = has(*options.layers, layer.name);
    if (options.curve) {
        sheet.view.activeCurve = static_cast<int>(*options.curve);
        for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
            CurveView view = viewOf(sheet.curves[i]);
            view.isShown = i == *options.curve;
            sheet.curves[i] = withView(std::move(sheet.curves[i]), view);
        }
    }
    return sheet;
}

/// The figure of a sheet on the page of a box.
Drawing drawn(Figure figure, const Box& box, const Document& document, SheetIndex sheet, const TextSource& texts,
              const DrawingOptions& options) {
    Drawing drawing;
    const std::optional<double>& scale = options.mmPerUnit ? options.mmPerUnit : document.sheets[sheet].view.mmPerUnit;
    drawing.page =
        options.width ? pageOfWidth(box, *options.width, options.margin) : pageOf(box, scale, options.margin);
    drawing.layerTitles = titlesOf(figure, layersOf(sheet), texts);
    drawing.figure = std::move(figure);
    drawing.title = document.title.empty() ? texts.translate(captionOf(sheet)) : document.title;
    drawing.description = describe(sheet, drawing.layerTitles, texts);
    drawing.theme = options.theme;
    return drawing;
}

/// Those of the frames, and the box of all.
struct FrameFigures {
    std::vector<Figure> figures;
    Box box;
    std::optional<FileError> refusal;
};
std::optional<FrameFigures> frameFigures(const Document& document, SheetIndex sheet, std::span<const FramePlace> places,
                                         const DrawingOptions& options, WorkBudget& budget) {
    const Sheet onView = chosen(document.sheets[sheet], sheet, options);
    FrameFigures frames;
    for (const FramePlace& place : places) {
        const std::optional<Frame<Sheet>> frame = atFrame(onView, place);
        if (!frame)
            return {};
        const Relations relations = shownRelations(frame->value, sheet, budget);
        if (relations.refusal)
            frames.refusal = relations.refusal;
        frames.figures.push_back(lettered(figureOf(frame->value, sheet, relations, frame->layerStage), options));
        frames.box = united(frames.box, boxOf(frames.figures.back()));
    }
    return frames;
}

void move(Figure& figure, Vector by) {
    const auto moveAll = [by](Points& points) {
        for (Point& p : points)
            p = p + by;
    };
    for (Layer& layer : figure.layers) {
        for (Stroke& stroke : layer.strokes)
            moveAll(stroke.path.points);
        for (Marks& marks : layer.marks)
            moveAll(marks.at);
        for (Label& label : layer.labels)
            label.at = label.at + by;
    }
}

} // namespace

Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts, const DrawingOptions& options) {
    WorkBudget budget(limits::kSteps);
    return drawingOf(document, sheet, texts, options, budget);
}

Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts, const DrawingOptions& options,
                  WorkBudget& budget) {
    const Sheet onView = chosen(document.sheets[sheet], sheet, options);
    const Relations relations = shownRelations(onView, sheet, budget);
    Figure figure = lettered(figureOf(onView, sheet, relations, options.stage), options);
    const Box box = boxOf(figure);
    Drawing drawing = drawn(std::move(figure), box, document, sheet, texts, options);
    drawing.sheet = sheet;
    drawing.refusal = relations.refusal;
    return drawing;
}

std::optional<std::vector<Drawing>> framesOf(const Document& document, SheetIndex sheet,
                                             std::span<const FramePlace> places, const TextSource& texts,
                                             const DrawingOptions& options, WorkBudget& budget) {
    std::optional<FrameFigures> frames = frameFigures(document, sheet, places, options, budget);
    if (!frames)
        return {};
    std::vector<Drawing> drawings;
    for (Figure& figure : frames->figures) {
        drawings.push_back(drawn(std::move(figure), frames->box, document, sheet, texts, options));
        drawings.back().refusal = frames->refusal;
    }
    return drawings;
}

std::optional<Drawing> frameStripOf(const Document& document, SheetIndex sheet, std::span<const FramePlace> places,
                                    const TextSource& texts, const DrawingOptions& options, WorkBudget& budget) {
    constexpr double kGap = 0.18; // of a frame's longer side: more than its labels need
    std::optional<FrameFigures> frames = frameFigures(document, sheet, places, options, budget);
    if (!frames)
        return {};
    const double step = frames->box.width() + kGap * std::max(frames->box.width(), frames->box.height());
    Box all;
    for (std::size_t i = 0; i < frames->figures.size(); ++i) {
        const Vector by{static_cast<double>(i) * step, 0};
        move(frames->figures[i], by);
        all = united(all, {frames->box.xmin + by.x, frames->box.ymin, frames->box.xmax + by.x, frames->box.ymax});
    }
    Drawing strip = drawn(united(std::move(frames->figures), layersOf(sheet)), all, document, sheet, texts, options);
    strip.refusal = frames->refusal;
    return strip;
}

Drawing drawingOf(std::span<const Plot> plots, const TextSource& texts, const DrawingOptions& options) {
    PlotSize size;
    if (options.width) {
        const double width = *options.width - 2 * options.margin;
        size = {width, width * size.height / size.width};
    }
    Drawing drawing;
    drawing.figure = lettered(plotFigure(plots, size), options);
    if (options.layers)
        std::erase_if(drawing.figure.layers, [&](const Layer& layer) { return !has(*options.layers, layer.name); });
    drawing.page = plotPage(plots.size(), size, options.margin);
    drawing.layerTitles = titlesOf(drawing.figure, plotLayers(), texts);
    drawing.theme = options.theme;
    for (const Plot& plot : plots)
        drawing.title.append(drawing.title.empty() ? "" : ", ").append(texts.translate(plot.caption));
    drawing.description = drawing.title;
    return drawing;
}

} // namespace kriva
