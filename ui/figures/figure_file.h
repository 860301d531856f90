#pragma once

#include "core/io/drawing.h"
#include "core/io/latex/tikz_writer.h"
#include "ui/figures/picture_files.h"

#include <QString>

#include <variant>

namespace kriva::ui {

enum class FigureFormat { svg, pdf, png, tikz, csv };

/// By the end of a file's name: .svg, .pdf, .png, .tex or .csv, in small letters or capitals.
[[nodiscard]] std::optional<FigureFormat> figureFormatOf(const QString& path);

/// ".svg"
[[nodiscard]] QString suffixOf(FigureFormat format);

/// What a person wants of the file of a figure. What a format does not have is not looked at.
struct FigureFileOptions {
    FigureFormat format = FigureFormat::svg;
    DrawingOptions drawing = {};
    bool holdsDocument = true;        ///< of SVG
    std::optional<int> decimals = {}; ///< of SVG; exact where there are none
    bool hasInkscapeLayers = false;   ///< of SVG
    int dpi = kUsualDpi;              ///< of PNG
    bool isTransparent = false;       ///< of PNG
    TikzKind tikz = TikzKind::standalone;
};

/// Why there is no such file.
enum class FigureFault {
    tooManyPixels, ///< a side of more than kMostPixels
    beyondTex,     ///< a side longer than TeX can count, kMostTexSide
};
/// The same as a part of a sentence in the present language.
[[nodiscard]] QString faultText(FigureFault fault);

using FigureFile = std::variant<QByteArray, FigureFault>;

/// The file of a drawing, which is no document and has no points: not CSV.
[[nodiscard]] FigureFile drawingFile(const Drawing& drawing, const FigureFileOptions& options);

/// The file of a sheet's figure. CSV holds the points of the curves that are drawn.
[[nodiscard]] FigureFile figureFile(const Document& document, SheetIndex sheet, const FigureFileOptions& options);

} // namespace kriva::ui
