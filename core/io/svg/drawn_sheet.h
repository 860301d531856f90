#pragma once

#include "core/io/drawing/drawing.h"

namespace kriva {

/// What an SVG figure with its document inside draws of it, and where: enough to find the document's curves again in
/// its paths, whoever saved the file.
struct DrawnSheet {
    SheetIndex sheet = 0;
    std::vector<int> curves; ///< their indices, in the order of drawing
    double mmPerUnit = 1;
    double margin = 0; ///< of the page, in millimetres
    Point corner;      ///< in document coordinates: of the figure's box, at the top left inside the margin
    int decimals = 0;  ///< of coordinates in millimetres
    friend bool operator==(const DrawnSheet&, const DrawnSheet&) = default;
};

/// Of a drawing with a sheet, written with so many decimals.
[[nodiscard]] DrawnSheet drawnSheetOf(const Drawing& drawing, int decimals);

/// As one line of JSON: {"sheet":"spline","curves":[0,1],"mmPerUnit":2.5,"margin":6,"corner":[0,10],"decimals":3}.
/// readDrawnSheet gives it back bit for bit, and nothing for what is none.
[[nodiscard]] std::string writeDrawnSheet(const DrawnSheet& drawn);
[[nodiscard]] std::optional<DrawnSheet> readDrawnSheet(std::string_view json);

/// A page on which onPage() gives the same as on the drawing's, bit for bit.
[[nodiscard]] Page pageOf(const DrawnSheet& drawn);

/// A place of the page, as onPage() gives it, in the document.
[[nodiscard]] Point inDocument(const DrawnSheet& drawn, Point onPage);

} // namespace kriva
