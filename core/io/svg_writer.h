#pragma once

#include "core/document/document.h"
#include "core/figure/page.h"
#include "core/figure/plot/plot.h"
#include "core/figure/role_style.h"
#include "core/figure/text_source.h"

namespace kriva {

/// What an SVG file says beside its figure.
struct SvgContent {
    Figure figure;
    Page page;
    std::string title;
    std::string description;
    std::string document; ///< JSON that goes along in the metadata; empty for none
    Theme theme = Theme::light;
    bool hasPaper = true; ///< a background of the paper's colour
};

/// A figure as an SVG file: layers as groups `layer-NAME`, the path of a curve itself `curve-N`, presentation
/// attributes only, coordinates in millimetres. The same content gives the same bytes.
[[nodiscard]] std::string writeSvg(const SvgContent& content, const TextSource& texts);

struct SvgOptions {
    Theme theme = Theme::light;
    bool holdsDocument = true; ///< so that the file opens again in Kriva
};

/// The figure of a sheet under its view as an SVG file; readDocumentFromSvg gives the document back bit for bit.
[[nodiscard]] std::string writeSheetSvg(const Document& document, SheetIndex sheet, const TextSource& texts,
                                        const SvgOptions& options = {});

/// Plots as an SVG file, each as large as PlotSize is at first, one above the other.
[[nodiscard]] std::string writePlotsSvg(std::span<const Plot> plots, const TextSource& texts,
                                        Theme theme = Theme::light);

} // namespace kriva
