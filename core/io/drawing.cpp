#include "core/io/drawing.h"

#include "core/figure/plot/plot_figure.h"

#include <algorithm>

namespace kriva {
namespace {

std::vector<std::string> titlesOf(const Figure& figure, SheetIndex sheet, const TextSource& texts) {
    std::vector<std::string> titles;
    for (const Layer& layer : figure.layers) {
        const auto info = std::ranges::find(layersOf(sheet), layer.name, &LayerInfo::name);
        titles.push_back(info == layersOf(sheet).end() ? std::string(layer.name) : texts.translate(info->caption));
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

/// The sheet with only what the options name on view.
Sheet chosen(Sheet sheet, SheetIndex index, const DrawingOptions& options) {
    if (options.layers)
        for (const LayerInfo& layer : layersOf(index))
            sheet.view.layers[std::string(layer.name)] =
                std::ranges::find(*options.layers, layer.name) != options.layers->end();
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

} // namespace

Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts, const DrawingOptions& options) {
    const Sheet onView = chosen(document.sheets[sheet], sheet, options);
    Drawing drawing;
    drawing.figure = figureOf(onView, sheet);
    if (!options.hasLabels)
        for (Layer& layer : drawing.figure.layers)
            layer.labels.clear();
    const Box box = boxOf(drawing.figure);
    drawing.page = options.width ? pageOfWidth(box, *options.width, options.margin)
                                 : pageOf(box, onView.view.mmPerUnit, options.margin);
    drawing.layerTitles = titlesOf(drawing.figure, sheet, texts);
    drawing.title = document.title.empty() ? texts.translate(captionOf(sheet)) : document.title;
    drawing.description = describe(sheet, drawing.layerTitles, texts);
    drawing.theme = options.theme;
    return drawing;
}

Drawing drawingOf(std::span<const Plot> plots, const TextSource& texts, Theme theme) {
    const PlotSize size;
    Drawing drawing;
    drawing.figure = plotFigure(plots, size);
    drawing.page = plotPage(plots.size(), size);
    drawing.theme = theme;
    for (const Plot& plot : plots)
        drawing.title.append(drawing.title.empty() ? "" : ", ").append(texts.translate(plot.caption));
    drawing.description = drawing.title;
    return drawing;
}

} // namespace kriva
