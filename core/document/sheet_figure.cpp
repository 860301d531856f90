#include "core/document/sheet_figure.h"

#include "core/curve/limits.h"

#include <algorithm>
#include <utility>

namespace kriva {
namespace {

std::string_view layerOf(const Curve& curve, GripKind kind) {
    return std::visit([&](const auto& c) { return layerOf(c, kind); }, curve);
}

/// The one composition of what a sheet makes of a curve: its style, and what the view shows of it.
Figure composed(Figure figure, const Curve& curve, const FigureContext& context) {
    return shownLayers(styled(std::move(figure), styleOf(curve)), layersOf(curve.index()), context);
}

Figure unstyledFigure(const Curve& curve, const FigureContext& context) {
    return std::visit([&](const auto& c) { return figureOf(c, context); }, curve);
}

/// Figure and grips as the curve's sheet gives them.
template <class C>
std::optional<DrawnCurve> drawnAsItIs(const C& curve, const FigureContext& context, WorkBudget& budget) {
    if constexpr (C::kCapabilities.longDrawing)
        return drawn(curve, context, budget);
    else if (!budget.spend())
        return {};
    else
        return DrawnCurve{figureOf(curve, context), grips(curve)};
}

} // namespace

Figure figureOf(const Curve& curve, const FigureContext& context) {
    return styled(unstyledFigure(curve, context), styleOf(curve));
}

std::optional<DrawnCurve> drawn(const Curve& curve, const FigureContext& context, WorkBudget& budget) {
    std::optional<DrawnCurve> all = std::visit([&](const auto& c) { return drawnAsItIs(c, context, budget); }, curve);
    if (!all)
        return {};
    all->figure = composed(std::move(all->figure), curve, context);
    std::vector<GripKind> hidden; // asked once for each kind: a curve may have as many grips as points
    for (const GripKind kind : kGripKinds)
        if (!isDrawn(layerOf(curve, kind), layersOf(curve.index()), context))
            hidden.push_back(kind);
    if (!hidden.empty())
        std::erase_if(all->grips,
                      [&](const Grip& grip) { return std::ranges::find(hidden, grip.id.kind) != hidden.end(); });
    return all;
}

DrawnCurve drawnPoints(const Curve& curve, const FigureContext& context) {
    const std::string_view layer = layerOf(curve, GripKind::point);
    if (!isDrawn(layer, layersOf(curve.index()), context))
        return {};
    Points points;
    points.reserve(pointCount(curve));
    for (std::size_t i = 0; i < pointCount(curve); ++i)
        points.push_back(pointAt(curve, static_cast<int>(i)));
    DrawnCurve drawn{{}, pointGrips(points)};
    drawn.figure.layers.push_back({layer, {}, {{std::move(points), Role::point}}});
    return drawn;
}

std::uint64_t drawingSteps(const Curve& curve) {
    return std::visit([](const auto& c) { return drawingSteps(c); }, curve);
}

std::optional<Frame<Sheet>> atFrame(const Sheet& sheet, const FramePlace& place) {
    if (sheet.curves.empty())
        return {};
    const auto active = static_cast<std::size_t>(sheet.view.activeCurve);
    return std::visit(
        [&]<class C>(const C& curve) -> std::optional<Frame<Sheet>> {
            if constexpr (C::kCapabilities.animation)
                if (std::optional<Frame<C>> there = atFrame(curve, place)) {
                    Frame<Sheet> frame{sheet, there->layerStage};
                    frame.value.curves[active] = Curve(std::move(there->value));
                    return frame;
                }
            return {};
        },
        sheet.curves[active]);
}

FigureContext contextOf(const Sheet& sheet, int curve, std::optional<int> stage) {
    const bool isActive = curve == sheet.view.activeCurve;
    return {curve, isActive, &sheet.view, isActive ? stage : std::nullopt};
}

Figure figureOfCurves(const Sheet& sheet, SheetIndex index, std::optional<int> stage) {
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
        const Curve& curve = sheet.curves[i];
        if (!viewOf(curve).isShown)
            continue;
        const FigureContext context = contextOf(sheet, static_cast<int>(i), stage);
        figures.push_back(composed(unstyledFigure(curve, context), curve, context));
    }
    return united(std::move(figures), layersOf(index));
}

Figure figureOf(const Sheet& sheet, SheetIndex index, std::optional<int> stage) {
    WorkBudget budget(limits::kSteps);
    return figureOf(sheet, index, shownRelations(sheet, index, budget), stage);
}

Figure figureOf(const Sheet& sheet, SheetIndex index, const Relations& relations, std::optional<int> stage) {
    Figure figure = figureOfCurves(sheet, index, stage);
    if (relations.figure.layers.empty())
        return figure;
    return united({std::move(figure), figureOfRelations(sheet, index, relations)}, layersOf(index));
}

Figure figureOfRelations(const Sheet& sheet, SheetIndex index, const Relations& relations) {
    return shownLayers(relations.figure, layersOf(index), {.view = &sheet.view});
}

Relations shownRelations(const Sheet& sheet, SheetIndex index, WorkBudget& budget) {
    const bool areShown = std::ranges::any_of(
        layersOf(index), [&](const LayerInfo& layer) { return layer.isOfSheet && isShown(layer, sheet.view); });
    return areShown ? relationsOf(sheet, index, budget).value_or(Relations()) : Relations(); // they may take seconds
}

} // namespace kriva
