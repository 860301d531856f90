#pragma once

#include <string_view>

namespace kriva {

/// The namespace of the element `document` in the metadata of an SVG file: it holds the document as JSON.
inline constexpr std::string_view kSvgDocumentNamespace = "https://kriva.invalid/ns";

/// The id of the layer with the curves themselves in a figure of Kriva's.
inline constexpr char kSvgCurveLayer[] = "layer-curve";

} // namespace kriva
