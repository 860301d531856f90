#pragma once

#include <string_view>

namespace kriva {

/// The namespace of the element `document` in the metadata of an SVG file: it holds the document as JSON.
inline constexpr std::string_view kSvgDocumentNamespace = "https://kriva.invalid/ns";

} // namespace kriva
