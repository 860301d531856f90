#pragma once

#include "core/io/drawing/drawing.h"

#include <QByteArray>
#include <QString>

#include <variant>
#include <vector>

namespace kriva::ui {

/// By the end of a file's name: .svg, .pdf, .png, .tex or .csv, in small letters or capitals.
[[nodiscard]] std::optional<FigureFormat> figureFormatOf(const QString& path);

/// ".svg"
[[nodiscard]] QString suffixOf(FigureFormat format);

/// Why there is no such file, whatever the curves.
enum class FigureFault {
    tooManyPixels, ///< a side of more than kMostPixels
    beyondTex,     ///< a side longer than TeX can count, kMostTexSide
    noSuchFrame,   ///< the active curve's animation does not have one of the frames
};
/// The same as a part of a sentence in the present language.
[[nodiscard]] QString faultText(FigureFault fault);

/// The bytes; or why there is no file, of curves that are beyond a limit as well.
using FigureFile = std::variant<QByteArray, FigureFault, FileError>;
/// Why there is none, likewise; empty where there is one.
[[nodiscard]] QString faultText(const FigureFile& file);

/// The file of a drawing, which has no points: not CSV. A document goes along where the options and the format let it.
[[nodiscard]] FigureFile drawingFile(const Drawing& drawing, const FigureFileOptions& options,
                                     const Document* document = nullptr);

/// The file of a sheet's figure, or of the frames asked for; on any thread. CSV holds the points of the curves that are
/// drawn. Of no use where the budget was stopped.
[[nodiscard]] FigureFile figureFile(const Document& document, SheetIndex sheet, const FigureFileOptions& options,
                                    WorkBudget& budget);

/// A file for each of the frames, without a document; all pages are of one size. Not CSV.
[[nodiscard]] std::vector<FigureFile> frameFiles(const Document& document, SheetIndex sheet,
                                                 const FigureFileOptions& options, WorkBudget& budget);

} // namespace kriva::ui
