#pragma once

#include "core/document/document.h"
#include "core/figure/page.h"
#include "core/figure/plot/plot.h"
#include "core/figure/role_style.h"
#include "core/figure/text_source.h"

namespace kriva {

/// A figure on its page and what is said about it: what the files of every format show.
struct Drawing {
    Figure figure;
    Page page;
    std::vector<std::string> layerTitles; ///< for people; one for each layer, or none
    std::string title;
    std::string description;
    Theme theme = Theme::light;
    bool hasPaper = true; ///< a background of the paper's colour
};

/// How a sheet is to be drawn, where not as its view has it.
struct DrawingOptions {
    /// Of the page, in millimetres, more than both margins; nothing where the view's scale decides.
    std::optional<double> width = {};
    double margin = kPageMargin;                         ///< in millimetres
    std::optional<std::vector<std::string>> layers = {}; ///< these alone, by name
    std::optional<std::size_t> curve = {};               ///< this one alone, as the active curve
    bool hasLabels = true;
    Theme theme = Theme::light;
};

/// The figure of a sheet.
[[nodiscard]] Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts,
                                const DrawingOptions& options = {});

/// Plots, each as large as PlotSize is at first, one above the other.
[[nodiscard]] Drawing drawingOf(std::span<const Plot> plots, const TextSource& texts, Theme theme = Theme::light);

} // namespace kriva
