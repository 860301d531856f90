#pragma once

#include "core/curve/relations.h"
#include "core/sheets/combined/combined_sheet.h"
#include "core/sheets/elevation/elevation_sheet.h"
#include "core/sheets/spline/spline_sheet.h"
#include "core/sheets/subdivision/subdivision_sheet.h"

#include <array>

namespace kriva {

/// A curve of any sheet. The order of its kinds is the order of the sheets; a further sheet is one more kind here.
using Curve = std::variant<ElevationCurve, SubdivisionCurve, SplineCurve, CombinedCurve>;

/// Which sheet: the index of its kind of curve.
using SheetIndex = std::size_t;
inline constexpr SheetIndex kSheetCount = std::variant_size_v<Curve>;

struct Sheet {
    std::vector<Curve> curves; ///< all of the sheet's own kind
    SheetView view;
    std::optional<int> stage = {}; ///< of the active curve, as a player shows it: of the moment, never saved
    friend bool operator==(const Sheet&, const Sheet&) = default;
};

struct Document {
    std::string title;
    SheetIndex active = 0;
    std::array<Sheet, kSheetCount> sheets;
    friend bool operator==(const Document&, const Document&) = default;
};

/// The name of a sheet in documents: "elevation".
[[nodiscard]] std::string_view sheetName(SheetIndex sheet);
[[nodiscard]] std::optional<SheetIndex> sheetNamed(std::string_view name);
/// Its name for people.
[[nodiscard]] Caption captionOf(SheetIndex sheet);
/// A curve of the sheet's kind without points.
[[nodiscard]] Curve emptyCurve(SheetIndex sheet);

/// The curves of a sheet of this kind.
template <class C>
[[nodiscard]] std::vector<const C*> curvesOf(const Sheet& sheet) {
    std::vector<const C*> curves;
    for (const Curve& curve : sheet.curves)
        curves.push_back(&std::get<C>(curve));
    return curves;
}

/// Whether two documents differ in what is saved and undone: `active` and `view` do not count.
[[nodiscard]] bool sameContent(const Document& a, const Document& b);

// What every kind of curve can do, for those that do not care about the kind. See elevation_edits.h for each.
[[nodiscard]] const std::string& nameOf(const Curve& curve);
/// Any text may be the name: what is no character becomes U+FFFD, so that the document can be read again.
[[nodiscard]] Curve renamed(Curve curve, std::string_view name);
[[nodiscard]] const CurveView& viewOf(const Curve& curve);
[[nodiscard]] Curve withView(Curve curve, CurveView view);
[[nodiscard]] const CurveStyle& styleOf(const Curve& curve);
[[nodiscard]] Curve withStyle(Curve curve, CurveStyle style);
[[nodiscard]] bool isIncomplete(const Curve& curve);
[[nodiscard]] std::size_t pointCount(const Curve& curve);
[[nodiscard]] Point pointAt(const Curve& curve, int index);
[[nodiscard]] std::size_t derivedPointCount(const Curve& curve);
[[nodiscard]] std::size_t mostPoints(const Curve& curve);
[[nodiscard]] bool isWithin(const Curve& curve, double limit);
[[nodiscard]] std::vector<Grip> grips(const Curve& curve);
[[nodiscard]] Curve withGripsMoved(const Curve& curve, std::span<const GripId> ids, Vector by);
/// By value, so that adding many to a moved curve copies nothing.
[[nodiscard]] Edited<Curve> withPointAdded(Curve curve, Point at);
[[nodiscard]] Curve withPointsAdded(Curve curve, std::span<const Point> points);
/// A path behind its own points: splines take its pieces as they are, the others its points.
[[nodiscard]] Curve withPathAdded(Curve curve, const Path& path);
/// The points of another curve of the same kind behind its own, with all that belongs to them.
[[nodiscard]] Curve appended(Curve curve, const Curve& other);
/// A point more near a place of the curve that keeps its shape; nothing where the curve has no room for one.
[[nodiscard]] std::optional<Edited<Curve>> withPointInserted(const Curve& curve, Point near);
/// The curve pulled where it is nearest to `from`; nothing where it gives way to no pull.
[[nodiscard]] std::optional<Curve> withCurvePulled(const Curve& curve, Point from, Vector by);
[[nodiscard]] Edited<Curve> withPointsRemoved(const Curve& curve, const std::vector<int>& indices);
/// The same with the neighbours refitted where the curve has pieces, so that its shape changes least.
[[nodiscard]] Refitted<Curve> withPointsRemovedRefitted(const Curve& curve, const std::vector<int>& indices);
/// The degree where one polynomial runs through all points, so that it falls when one is removed; else nothing.
[[nodiscard]] std::optional<int> polynomialDegree(const Curve& curve);
[[nodiscard]] Edited<Curve> reversed(const Curve& curve);
[[nodiscard]] std::span<const LayerInfo> layersOf(SheetIndex sheet);
[[nodiscard]] Figure figureOf(const Curve& curve, const FigureContext& context);
/// The layers that the view shows, and the grips of those that it draws: nobody takes hold of what is hidden. Nothing
/// where the budget ends.
[[nodiscard]] std::optional<DrawnCurve> drawn(const Curve& curve, const FigureContext& context, WorkBudget& budget);
/// What of that needs no work: its points, which stand in for it until it has come.
[[nodiscard]] DrawnCurve drawnPoints(const Curve& curve, const FigureContext& context);
/// About how many steps of a budget drawn() takes.
[[nodiscard]] std::uint64_t drawingSteps(const Curve& curve);
[[nodiscard]] std::optional<std::vector<Result>> results(const Curve& curve, WorkBudget& budget);
[[nodiscard]] std::vector<Result> results(const Curve& curve);

/// The sheet with its active curve at that place of its animation; nothing where it has no such place.
[[nodiscard]] std::optional<Sheet> atFrame(Sheet sheet, const FramePlace& place);

/// What the curves of a sheet have with each other; without rows in sheets where nobody asks. May take seconds, and
/// gives nothing where it was stopped. What is beyond the budget is an answer too: Relations::refusal.
[[nodiscard]] std::optional<Relations> relationsOf(std::span<const Curve* const> curves, SheetIndex index,
                                                   WorkBudget& budget);
[[nodiscard]] std::optional<Relations> relationsOf(const Sheet& sheet, SheetIndex index, WorkBudget& budget);
/// The same within limits::kSteps.
[[nodiscard]] Relations relationsOf(const Sheet& sheet, SheetIndex index);

/// How a curve of the sheet, which outlives this, enters its figure.
[[nodiscard]] FigureContext contextOf(const Sheet& sheet, int curve);

/// The figure of a whole sheet under its view: what its canvas shows and an export draws. Relations that are beyond the
/// limits are not in it.
[[nodiscard]] Figure figureOf(const Sheet& sheet, SheetIndex index);
/// The same with relations that are known, as shownRelations() gives them.
[[nodiscard]] Figure figureOf(const Sheet& sheet, SheetIndex index, const Relations& relations);
/// What the curves have with each other if the view shows it, otherwise empty, and where it was stopped.
[[nodiscard]] Relations shownRelations(const Sheet& sheet, SheetIndex index, WorkBudget& budget);
/// The same without the relations of the curves: quick, and of the same box.
[[nodiscard]] Figure figureOfCurves(const Sheet& sheet, SheetIndex index);

} // namespace kriva
