#pragma once

#include "core/io/svg/svg_writer.h"

namespace kriva::test {

/// The figure of a sheet with the document in the file, so that it opens again.
inline std::string sheetSvg(const Document& document, SheetIndex sheet, const TextSource& texts,
                            const DrawingOptions& drawing = {}, SvgOptions options = {}) {
    options.document = documentForSvg(document);
    return writeSvg(drawingOf(document, sheet, texts, drawing), texts, options);
}

} // namespace kriva::test
