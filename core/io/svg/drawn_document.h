#pragma once

#include "core/document/document.h"

namespace kriva {

/// The document inside a figure as the lines of the file draw it, where somebody edited those elsewhere by more than a
/// thousandth of a millimetre: in the sheet of the figure, what was changed, added to the layer of the curves or taken
/// out of it is as there, all else as inside. A changed curve keeps its name, its style and its view, and takes the
/// path as an imported one. Nothing where the lines are the document's own, where the file does not tell which those
/// are (a plot, frames), and where the sheet cannot take them. Linear in the lines.
[[nodiscard]] std::optional<Document> drawnDocument(std::string_view svg, const Document& inside);

} // namespace kriva
