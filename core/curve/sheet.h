#pragma once

#include "core/budget/work_budget.h"
#include "core/curve/capabilities.h"
#include "core/curve/editing/drawn_curve.h"
#include "core/curve/editing/edited.h"
#include "core/curve/editing/grip.h"
#include "core/curve/editing/handle_way.h"
#include "core/curve/output.h"
#include "core/curve/relations.h"
#include "core/curve/table.h"
#include "core/figure/plot/plot.h"
#include "core/figure/style/frame_place.h"
#include "core/figure/style/view_setting.h"

#include <concepts>

namespace kriva {

class JsonNode;
class JsonWriter;

// The form that a sheet fills in: what its curve is and the functions that are overloaded for it. isSheet() at the end
// checks it, so that one that is missing or misspelt is an error of the compiler, which names it.

/// A plain value that knows its sheet.
template <class C>
concept SheetValue = std::regular<C> && requires(const C& curve, C& changed) {
    // The sheet's name in documents, "elevation", and its name for people.
    { C::kSheet } -> std::convertible_to<std::string_view>;
    { C::kCaption } -> std::convertible_to<Caption>;
    { C::kCapabilities } -> std::convertible_to<Capabilities>;
    { changed.name } -> std::same_as<std::string&>;
    { changed.style } -> std::same_as<CurveStyle&>;
    { changed.view } -> std::same_as<CurveView&>;
    // Still being drawn: fewer points than a curve needs.
    { isIncomplete(curve) } -> std::same_as<bool>;
};

/// What it consists of.
template <class C>
concept SheetPoints = requires(const C& curve, int index, double limit, GripKind kind) {
    // The points of the Points table.
    { pointCount(curve) } -> std::same_as<std::size_t>;
    { pointAt(curve, index) } -> std::same_as<Point>;
    // How many points its results hold: they are limited over the whole sheet.
    { derivedPointCount(curve) } -> std::same_as<std::size_t>;
    // Why it has more points than a curve of this kind may have; nothing where it has not.
    { pointLimitError(curve) } -> std::same_as<std::optional<FileError>>;
    // Whether all its stored coordinates are at most `limit` in absolute value.
    { isWithin(curve, limit) } -> std::same_as<bool>;
    // The degree where one polynomial runs through all points; nothing for pieces and incomplete curves.
    { polynomialDegree(curve) } -> std::same_as<std::optional<int>>;
    // Everything that can be dragged, points first, in their order.
    { grips(curve) } -> std::same_as<std::vector<Grip>>;
    // The layer with the marks that such grips are taken hold of by.
    { layerOf(curve, kind) } -> std::same_as<std::string_view>;
};

/// Its edits: each returns the new value with all its counts valid.
template <class C>
concept SheetEdits = requires(const C& curve, std::span<const GripId> ids, const std::vector<int>& indices,
                              std::optional<int> index, std::span<const Point> points, Point point, Vector by) {
    // All the named grips moved by the same vector; grips that do not exist are passed over.
    { withGripsMoved(curve, ids, by) } -> std::same_as<C>;
    // Points behind its own; those of another curve come with all that belongs to them.
    { withPointAdded(curve, point) } -> std::same_as<Edited<C>>;
    { withPointsAdded(curve, points) } -> std::same_as<C>;
    { appended(curve, curve) } -> std::same_as<C>;
    // A point more near a place, or behind the point `index`, or anywhere, that keeps the shape as far as the kind of
    // curve can; nothing where there is no room for one.
    { withPointInserted(curve, point) } -> std::same_as<std::optional<Edited<C>>>;
    { withPointInsertedBehind(curve, index) } -> std::same_as<std::optional<Edited<C>>>;
    // The curve pulled where it is nearest to `point`; nothing where it gives way to no pull.
    { withCurvePulled(curve, point, by) } -> std::same_as<std::optional<C>>;
    // `indices` ascending.
    { withPointsRemoved(curve, indices) } -> std::same_as<Edited<C>>;
    // The same curve from its other end.
    { reversed(curve) } -> std::same_as<Edited<C>>;
};

/// What comes out of it: figure, numbers, JSON.
template <class C>
concept SheetOutput = requires(const C& curve, C& read, const FigureContext& context, WorkBudget& budget,
                               const JsonNode& node, JsonWriter& json) {
    // The layers of the sheet, from the lowest to the topmost.
    { layersOf(curve) } -> std::same_as<std::span<const LayerInfo>>;
    // The layers of one curve. Those that a view hides may be missing or not; without a view all are there.
    { figureOf(curve, context) } -> std::same_as<Figure>;
    // About how many steps of a budget drawing takes: by them long work is told from what a frame has time for.
    { drawingSteps(curve) } -> std::same_as<std::uint64_t>;
    // Rows of numbers for people, of a complete curve; nothing where the budget ends.
    { results(curve, budget) } -> std::same_as<std::optional<std::vector<Result>>>;
    // Plots in groups, and tables, none of incomplete curves; nothing where the budget ends.
    { plotsOf(curve, budget) } -> std::same_as<std::optional<std::vector<PlotGroup>>>;
    { tablesOf(curve, budget) } -> std::same_as<std::optional<std::vector<Table>>>;
    // The members of a complete curve in the report, after its name.
    { reportCurve(json, curve) } -> std::same_as<void>;
    // Refuses what format.md does not allow; writes the keys that differ from their defaults.
    { readCurve(node, read) } -> std::same_as<void>;
    { writeCurve(json, curve) } -> std::same_as<void>;
};

// What a sheet fills in where its curve names the capability.

/// Handles, and arrows of derivatives, that a hand pulls.
template <class C>
concept PullsHandles = requires(const C& curve, int point, const GripId& handle, const HandleWay& way) {
    // Whether the points of this very curve have handles.
    { pullsHandles(curve) } -> std::same_as<bool>;
    // The curve with the handles of a point retracted, about to be pulled by its out handle; nothing where it has none.
    { readyToPull(curve, point) } -> std::same_as<std::optional<C>>;
    { withHandleDragged(curve, handle, way) } -> std::same_as<C>;
    // Nothing for grips that are no handles.
    { withHandleRetracted(curve, handle) } -> std::same_as<std::optional<C>>;
};

/// An open curve that is closed by a click on one of its points: on its first one, elsewhere nothing.
template <class C>
concept CanBeClosed = requires(const C& curve, int point) {
    { closedAt(curve, point) } -> std::same_as<std::optional<C>>;
};

/// A chain that takes the pieces of a path as they are, and whose neighbours are refitted where a point goes.
template <class C>
concept IsMadeOfPieces = requires(const C& curve, const Path& path, const std::vector<int>& indices) {
    { withPathAdded(curve, path) } -> std::same_as<C>;
    { withPointsRemovedRefitted(curve, indices) } -> std::same_as<Refitted<C>>;
};

/// The curve as it is at a place of its animation; nothing where it has no such place.
template <class C>
concept IsAnimated = requires(const C& curve, const FramePlace& place) {
    { atFrame(curve, place) } -> std::same_as<std::optional<Frame<C>>>;
};

/// What the curves of a sheet have with each other.
template <class C>
concept HasRelations = requires(std::span<const C* const> curves, JsonWriter& json, WorkBudget& budget) {
    // Rows of numbers, and a figure above theirs; nothing where the budget was stopped.
    { relationsOf(curves, budget) } -> std::same_as<std::optional<Relations>>;
    // The members of the sheet in the report after its curves; why there are none where the budget has ended.
    { reportTogether(json, curves, budget) } -> std::same_as<std::optional<FileError>>;
};

/// Figure and grips that are worked out together; nothing where the budget ends.
template <class C>
concept DrawsWithinBudget = requires(const C& curve, const FigureContext& context, WorkBudget& budget) {
    { drawn(curve, context, budget) } -> std::same_as<std::optional<DrawnCurve>>;
};

/// What the view of its sheet has besides layers. No other sheet has one of the same name.
template <class C>
concept HasViewSettings = requires(const C& curve) {
    { viewSettingsOf(curve) } -> std::same_as<std::span<const ViewSetting>>;
};

/// Why all curves of a sheet together take too long; nothing where they do not. The error has no place.
template <class C>
concept LimitsOutput = requires(std::span<const C* const> curves, Output output) {
    { outputLimitError(curves, output) } -> std::same_as<std::optional<FileError>>;
};

/// True, or an error of the compiler for a capability that is named and not there, or there and not named.
template <class C>
consteval bool hasItsCapabilities() {
    if constexpr (C::kCapabilities.handles)
        static_assert(PullsHandles<C>);
    else
        static_assert(!PullsHandles<C>, "kCapabilities does not name handles");
    if constexpr (C::kCapabilities.closing)
        static_assert(CanBeClosed<C>);
    else
        static_assert(!CanBeClosed<C>, "kCapabilities does not name closing");
    if constexpr (C::kCapabilities.pieces)
        static_assert(IsMadeOfPieces<C>);
    else
        static_assert(!IsMadeOfPieces<C>, "kCapabilities does not name pieces");
    if constexpr (C::kCapabilities.animation)
        static_assert(IsAnimated<C>);
    else
        static_assert(!IsAnimated<C>, "kCapabilities does not name animation");
    if constexpr (C::kCapabilities.relations)
        static_assert(HasRelations<C>);
    else
        static_assert(!HasRelations<C>, "kCapabilities does not name relations");
    if constexpr (C::kCapabilities.longDrawing)
        static_assert(DrawsWithinBudget<C>);
    else
        static_assert(!DrawsWithinBudget<C>, "kCapabilities does not name longDrawing");
    if constexpr (C::kCapabilities.viewSettings)
        static_assert(HasViewSettings<C>);
    else
        static_assert(!HasViewSettings<C>, "kCapabilities does not name viewSettings");
    if constexpr (C::kCapabilities.outputLimits)
        static_assert(LimitsOutput<C>);
    else
        static_assert(!LimitsOutput<C>, "kCapabilities does not name outputLimits");
    return true;
}

/// True, or an error of the compiler that names what is missing.
template <class C>
consteval bool isSheet() {
    static_assert(SheetValue<C>);
    static_assert(SheetPoints<C>);
    static_assert(SheetEdits<C>);
    static_assert(SheetOutput<C>);
    return hasItsCapabilities<C>();
}

} // namespace kriva
