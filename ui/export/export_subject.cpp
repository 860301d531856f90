#include "ui/export/export_subject.h"

#include "core/document/sheet_figure.h"
#include "core/figure/plot/plot_figure.h"
#include "ui/figures/caption_text.h"

namespace kriva::ui {
namespace {

Drawing drawn(const Document& document, SheetIndex sheet, FigureFileOptions options, std::optional<int> stage,
              WorkBudget& budget) {
    options.drawing.stage = stage;
    if (!options.frames.empty())
        if (auto strip = frameStripOf(document, sheet, options.frames, textSource(), options.drawing, budget))
            return *std::move(strip);
    return drawingOf(document, sheet, textSource(), options.drawing, budget);
}

} // namespace

ExportSubject sheetToExport(Document document, SheetIndex sheet, std::optional<int> stage) {
    ExportSubject subject;
    for (const LayerInfo& layer : layersOf(sheet))
        subject.layers.push_back({layer.name, layer.caption, isShown(layer, document.sheets[sheet].view)});
    subject.hasFrames = atFrame(document.sheets[sheet], {FramePlace::Over::stage, 1}).has_value();
    subject.drawing = [document = std::move(document), sheet, stage](const FigureFileOptions& options,
                                                                     WorkBudget& budget) {
        return drawn(document, sheet, options, stage, budget);
    };
    return subject;
}

ExportSubject plotsToExport(std::vector<Plot> plots) {
    ExportSubject subject;
    for (const LayerInfo& layer : plotLayers())
        subject.layers.push_back({layer.name, layer.caption});
    subject.isSheet = false;
    subject.drawing = [plots = std::move(plots)](const FigureFileOptions& options, WorkBudget&) {
        return drawingOf(plots, textSource(), options.drawing);
    };
    return subject;
}

} // namespace kriva::ui
