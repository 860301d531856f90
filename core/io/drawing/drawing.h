#pragma once

#include "core/document/document.h"
#include "core/figure/plot/plot.h"
#include "core/figure/role_style.h"
#include "core/figure/style/figure_options.h"
#include "core/figure/style/page.h"
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
    bool hasPaper = true;                 ///< a background of the paper's colour
    std::optional<SheetIndex> sheet = {}; ///< of which it is the figure, as it lies in the document
    /// Why something is missing in the figure: it may be looked at, but no file is made of it.
    std::optional<FileError> refusal = {};
};

/// The figure of a sheet. Where the budget is stopped, its curves alone; what is beyond its steps is told in `refusal`.
[[nodiscard]] Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts,
                                const DrawingOptions& options, WorkBudget& budget);
/// The same within limits::kSteps.
[[nodiscard]] Drawing drawingOf(const Document& document, SheetIndex sheet, const TextSource& texts,
                                const DrawingOptions& options = {});

/// Frames of the animation of a sheet's active curve on pages of one size and scale: where the options give a width, of
/// that one. Nothing where the curve lacks one of the places.
[[nodiscard]] std::optional<std::vector<Drawing>> framesOf(const Document& document, SheetIndex sheet,
                                                           std::span<const FramePlace> places, const TextSource& texts,
                                                           const DrawingOptions& options, WorkBudget& budget);
/// The same side by side on one page, from left to right; a width is that of all together.
[[nodiscard]] std::optional<Drawing> frameStripOf(const Document& document, SheetIndex sheet,
                                                  std::span<const FramePlace> places, const TextSource& texts,
                                                  const DrawingOptions& options, WorkBudget& budget);

/// Plots one above the other, each of the shape that PlotSize has at first and, without a width, of its size. They have
/// no scale.
[[nodiscard]] Drawing drawingOf(std::span<const Plot> plots, const TextSource& texts, const DrawingOptions& options);

} // namespace kriva
