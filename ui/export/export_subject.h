#pragma once

#include "core/io/drawing/drawing.h"

#include <functional>

namespace kriva::ui {

/// What a person exports, as the dialog about it has to know it.
struct ExportSubject {
    struct LayerChoice {
        std::string_view name;
        Caption caption = Caption::none;
        bool isShown = true; ///< where nothing else was chosen
    };
    std::vector<LayerChoice> layers;
    bool isSheet = true;    ///< it has points, a scale, and a document that goes along
    bool hasFrames = false; ///< of an animation
    /// On any thread; of no use where the budget was stopped.
    std::function<Drawing(const FigureFileOptions&, WorkBudget&)> drawing;
};

/// The figure of a sheet after a stage of its active curve's algorithm, or frames of it side by side.
[[nodiscard]] ExportSubject sheetToExport(Document document, SheetIndex sheet, std::optional<int> stage = {});

/// Plots one above the other.
[[nodiscard]] ExportSubject plotsToExport(std::vector<Plot> plots);

} // namespace kriva::ui
