#pragma once

#include <string_view>

/// What the parts of an SVG figure of Kriva's are called.
namespace kriva {

/// The namespace of our elements in the metadata.
inline constexpr std::string_view kSvgNamespace = "https://kriva.invalid/ns";
/// The element that holds the document as JSON.
inline constexpr std::string_view kSvgDocument = "document";
/// The element that holds a DrawnSheet.
inline constexpr std::string_view kSvgDrawing = "drawing";

/// The id of the group of a layer is this and its name.
inline constexpr std::string_view kSvgLayerId = "layer-";
/// The id of the path of a curve is this and its index in the sheet.
inline constexpr std::string_view kSvgCurveId = "curve-";

} // namespace kriva
