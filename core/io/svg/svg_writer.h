#pragma once

#include "core/figure/label_placement.h"
#include "core/io/drawing/drawing.h"

#include <functional>

namespace kriva {

struct SvgOptions {
    std::string document = {};        ///< JSON that goes along in the metadata; empty for none
    std::optional<int> decimals = {}; ///< of coordinates in millimetres; else as many as keep them to 1e-13 of the page
    bool hasInkscapeLayers = false;   ///< the groups are layers in Inkscape; the drawing has their titles
    /// Path data in millimetres of the page for the letters of a label, in place of text; empty for texts.
    std::function<std::string(const PlacedLabel&)> outlineOf = {};
};

/// A figure as an SVG file: layers as groups `layer-NAME`, the path of a curve itself `curve-N`, presentation
/// attributes only, coordinates in millimetres. The same drawing gives the same bytes.
[[nodiscard]] std::string writeSvg(const Drawing& drawing, const TextSource& texts, const SvgOptions& options = {});

/// Frames, at least one and all on pages of one size, that show one after the other for so many seconds each, over and
/// over (SMIL): layers that are the same in all of them stand still and are written once.
[[nodiscard]] std::string writeAnimatedSvg(std::span<const Drawing> frames, double seconds, const TextSource& texts,
                                           const SvgOptions& options = {});

/// The document as SvgOptions::document has it: readDocumentFromSvg gives it back bit for bit.
[[nodiscard]] std::string documentForSvg(const Document& document);

} // namespace kriva
