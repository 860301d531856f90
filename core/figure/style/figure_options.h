#pragma once

#include "core/figure/style/frame_place.h"
#include "core/figure/style/page.h"
#include "core/figure/style/theme.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// How a figure is written: chosen in the editor and remembered with the view of a sheet, or on the command line.
namespace kriva {

/// How a sheet is to be drawn, where not as its view has it.
struct DrawingOptions {
    /// Of the page, in millimetres, more than both margins; nothing where the scale decides.
    std::optional<double> width = {};
    /// The scale, in millimetres for a unit; nothing where the view's decides. A width goes before it.
    std::optional<double> mmPerUnit = {};
    double margin = kPageMargin;                         ///< in millimetres
    std::optional<std::vector<std::string>> layers = {}; ///< these alone, by name
    // What is of the moment is never remembered.
    std::optional<std::size_t> curve = {}; ///< this one alone, as the active curve
    std::optional<int> stage = {}; ///< after which the layers of the active curve are hidden, as a player has it
    bool hasLabels = true;
    Theme theme = Theme::light;
    friend bool operator==(const DrawingOptions&, const DrawingOptions&) = default;
};

enum class FigureFormat { svg, pdf, png, tikz, csv };

/// Names in documents and on the command line, in the order of choices. Files of a format end with a point and its
/// name.
inline const std::initializer_list<std::pair<std::string_view, FigureFormat>> kFormatNames = {
    {"svg", FigureFormat::svg},
    {"pdf", FigureFormat::pdf},
    {"png", FigureFormat::png},
    {"tex", FigureFormat::tikz},
    {"csv", FigureFormat::csv}};
inline const std::initializer_list<std::pair<std::string_view, Theme>> kThemeNames = {{"light", Theme::light},
                                                                                      {"dark", Theme::dark}};

enum class TikzKind {
    standalone, ///< a document of its own, one page as large as the figure
    fragment,   ///< a tikzpicture for \input; the document loads tikz
};

inline constexpr double kLeastScale = 1e-12; ///< millimetres for a unit
inline constexpr double kMostScale = 1e9;
inline constexpr double kMostPageSide = 10'000; ///< millimetres: of a width, and of a margin
inline constexpr int kMostDecimals = 12;
inline constexpr int kLeastDpi = 10;
inline constexpr int kUsualDpi = 300;
inline constexpr int kMostDpi = 4'800;
inline constexpr int kMostFrames = 200;       ///< of a strip or an animation
inline constexpr double kMostStage = 100'000; ///< that a frame shows
inline constexpr double kLeastFrameSeconds = 0.01;
inline constexpr double kMostFrameSeconds = 60;

/// What a person wants of the file of a figure. What a format does not have is not looked at.
struct FigureFileOptions {
    FigureFormat format = FigureFormat::svg;
    DrawingOptions drawing = {};
    bool holdsDocument = true;        ///< of SVG
    std::optional<int> decimals = {}; ///< of SVG; exact where there are none
    bool hasInkscapeLayers = false;   ///< of SVG
    bool hasOutlines = false;         ///< of SVG: letters are paths, which look the same without their font
    int dpi = kUsualDpi;              ///< of PNG
    bool isTransparent = false;       ///< of PNG
    TikzKind tikz = TikzKind::standalone;
    std::vector<FramePlace> frames = {}; ///< of the active curve's animation in place of the sheet: side by side
    bool isAnimated = false;             ///< of SVG with frames: one after the other
    double frameSeconds = 0.5;           ///< of each
    friend bool operator==(const FigureFileOptions&, const FigureFileOptions&) = default;
};

/// Whether the figure stands on paper, which has a colour; else what lies behind it is seen.
[[nodiscard]] inline bool hasPaper(const FigureFileOptions& options) {
    return options.format != FigureFormat::png || !options.isTransparent;
}

} // namespace kriva
