#pragma once

#include "core/document/document.h"

/// The figure of a sheet: what its canvas shows and its exports draw.
namespace kriva {

/// All layers of a curve, styled, whatever the view shows.
[[nodiscard]] Figure figureOf(const Curve& curve, const FigureContext& context);
/// The layers that the view shows, and the grips of those that it draws: nobody takes hold of what is hidden. Nothing
/// where the budget ends.
[[nodiscard]] std::optional<DrawnCurve> drawn(const Curve& curve, const FigureContext& context, WorkBudget& budget);
/// What of that needs no work: its points, which stand in for it until it has come.
[[nodiscard]] DrawnCurve drawnPoints(const Curve& curve, const FigureContext& context);
/// About how many steps of a budget drawn() takes.
[[nodiscard]] std::uint64_t drawingSteps(const Curve& curve);

/// The sheet with its active curve at that place of its animation; nothing where it has no such place.
[[nodiscard]] std::optional<Frame<Sheet>> atFrame(const Sheet& sheet, const FramePlace& place);

// `stage`: the one of the active curve's algorithm after which its layers are hidden; nothing shows all.

/// How a curve of the sheet, which outlives this, enters its figure.
[[nodiscard]] FigureContext contextOf(const Sheet& sheet, int curve, std::optional<int> stage = {});

/// The figure of a whole sheet under its view: what its canvas shows and an export draws. Relations that are beyond the
/// limits are not in it.
[[nodiscard]] Figure figureOf(const Sheet& sheet, SheetIndex index, std::optional<int> stage = {});
/// The same with relations that are known, as shownRelations() gives them.
[[nodiscard]] Figure figureOf(const Sheet& sheet, SheetIndex index, const Relations& relations,
                              std::optional<int> stage = {});
/// What the curves have with each other if the view shows it, otherwise empty, and where it was stopped.
[[nodiscard]] Relations shownRelations(const Sheet& sheet, SheetIndex index, WorkBudget& budget);
/// What the view shows of these relations.
[[nodiscard]] Figure figureOfRelations(const Sheet& sheet, SheetIndex index, const Relations& relations);
/// The figure without the relations of the curves: quick, and of the same box.
[[nodiscard]] Figure figureOfCurves(const Sheet& sheet, SheetIndex index, std::optional<int> stage = {});

} // namespace kriva
