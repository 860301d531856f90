#pragma once

#include "core/figure/caption.h"
#include "core/figure/style/style.h"
#include "core/geometry/box.h"

#include <string>
#include <string_view>

/// What is drawn, as plain values in document coordinates. The canvas and every exporter draw the same figure.
namespace kriva {

/// What a line, mark or label stands for; its colours, widths and markers are in role_style.h.
enum class Role {
    curve,
    controlPolygon,
    derivedPolygon,
    construction, ///< series: the level of the scheme
    left,
    right,
    point,
    knot,
    handle,
    join,
    run, ///< series: the number of the run
    curvePoint,
    crossing,
    derivative,
    tangent,
    hull,
    runPolygon, ///< series: the number of the run
    fit,        ///< the polynomial of a run, before it is joined to others; series likewise
    comb,       ///< series: 0 for the teeth, 1 for the line along their ends
    inflection,
    rule, ///< the chain that another rule makes of the same knots; series: the rule
    label,
    // of plots
    axis,
    gridLine,
    plotLine,  ///< series: the number of the line
    reference, ///< what a line is compared with
    plotMark,  ///< on a line, where it is looked at
};

/// Whether it is the curve itself, or a part of it.
[[nodiscard]] constexpr bool isOfCurve(Role role) {
    return role == Role::curve || role == Role::run || role == Role::join;
}

/// A chain of Bézier pieces of any degrees: piece i has degrees[i] + 1 points and starts where the one before ended.
/// One that is closed ends where it started.
struct Path {
    Points points;
    std::vector<int> degrees;
    bool isClosed = false;
    friend bool operator==(const Path&, const Path&) = default;
};

[[nodiscard]] inline Path polyline(std::span<const Point> points) {
    return {Points(points.begin(), points.end()), std::vector<int>(points.empty() ? 0 : points.size() - 1, 1), false};
}
[[nodiscard]] inline Path singleCurve(std::span<const Point> controlPoints) {
    return {Points(controlPoints.begin(), controlPoints.end()), {static_cast<int>(controlPoints.size()) - 1}, false};
}
/// The chain of pieces, each starting where the one before ended.
[[nodiscard]] Path chain(const std::vector<Points>& pieces, bool isClosed);
/// The pieces of a path, one after the other: visit(std::span<const Point> controlPoints).
template <class Visit>
void forEachPiece(const Path& path, Visit visit) {
    std::size_t start = 0;
    for (const int degree : path.degrees) {
        visit(std::span<const Point>(path.points).subspan(start, static_cast<std::size_t>(degree) + 1));
        start += static_cast<std::size_t>(degree);
    }
}

/// The points of a path for curves that take nothing but points: of a single piece its control points, of more the
/// places where they begin and end, a closed path's start once. Without pieces, its points.
[[nodiscard]] Points pointsOf(const Path& path);

struct Stroke {
    Path path;
    Role role = Role::curve;
    int series = 0;
    double strength = 1;   ///< from 0, invisible, to 1: polygons of earlier stages fade
    CurveStyle style = {}; ///< replaces the role's where set
    int curve = -1;        ///< of the curve itself: its index in the sheet
    friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// Marks of one kind at many places.
struct Marks {
    Points at;
    Role role = Role::point;
    int series = 0;
    std::optional<Marker> marker = {}; ///< replaces the role's
    friend bool operator==(const Marks&, const Marks&) = default;
};

/// On which side of its point a label stands: labels of one point keep out of each other's way. The words and numbers
/// of axes stand exactly to the left, to the right, above or below, whatever is there.
enum class LabelSide { aboveRight, aboveLeft, belowLeft, belowRight, left, right, above, below };

/// A number that a label has before its text, in the language of the figure.
struct LabelNumber {
    double value = 0;
    int decimals = 0;
    friend bool operator==(const LabelNumber&, const LabelNumber&) = default;
};

/// A letter with an index ("b" with "3" below), a caption, or a number, beside a point.
struct Label {
    Point at;
    Caption caption = Caption::none;
    std::string text;
    std::string subscript;
    Role role = Role::label;
    std::string suffix = {}; ///< behind the index, on the line of the text: "×3"
    LabelSide side = LabelSide::aboveRight;
    std::optional<LabelNumber> number = {};
    friend bool operator==(const Label&, const Label&) = default;
};

struct Layer {
    std::string_view name; ///< stable ASCII, from the table of layers of its sheet
    std::vector<Stroke> strokes = {};
    std::vector<Marks> marks = {};
    std::vector<Label> labels = {};
    friend bool operator==(const Layer&, const Layer&) = default;
};

/// The layer with the curves themselves, in every sheet.
inline constexpr std::string_view kCurveLayer = "curve";

/// Layers from the lowest to the topmost, in the order of the sheet's table.
struct Figure {
    std::vector<Layer> layers;
    friend bool operator==(const Figure&, const Figure&) = default;
};

/// One row of a sheet's table of layers.
struct LayerInfo {
    std::string_view name;
    Caption caption = Caption::none;
    bool isShownAtFirst = true;
    bool isOfActiveCurve = false; ///< derived layers are drawn for the active curve only
    /// Where the sheet's algorithm runs in stages, the one that brings the layer: earlier ones hide it. What is off at
    /// first shows in its own stage alone.
    int stage = 0;
    bool isOfSheet = false; ///< drawn for what the curves have with each other
};

/// How one curve of a sheet enters the figure.
struct FigureContext {
    int curve = 0; ///< index in the sheet
    bool isActive = true;
    const SheetView* view = nullptr; ///< of the sheet, which outlives this; nothing shows all there is, as at first
    std::optional<int> stage = {};   ///< of the sheet's algorithm; nothing where it has run through
};

/// The figure of a curve as its style asks for: the marks of its points in another shape, its labels left out.
[[nodiscard]] Figure styled(Figure figure, const CurveStyle& style);

/// The layers of several figures of one sheet, united by name.
[[nodiscard]] Figure united(std::vector<Figure> figures, std::span<const LayerInfo> order);

/// Whether a layer is shown under the view of its sheet.
[[nodiscard]] bool isShown(const LayerInfo& layer, const SheetView& view);

/// Whether a layer of the table is drawn: not where the view or the stage hides it, nor a layer of the active curve for
/// another one. Where it costs much, a figure asks before it makes the layer.
[[nodiscard]] bool isDrawn(std::string_view layer, std::span<const LayerInfo> table, const FigureContext& context);

/// The figure without the layers that are not drawn.
[[nodiscard]] Figure shownLayers(Figure figure, std::span<const LayerInfo> table, const FigureContext& context);

/// The box of the strokes, of curves themselves and not of their control points, and of all places of marks and labels.
[[nodiscard]] Box boxOf(const Figure& figure);

} // namespace kriva
