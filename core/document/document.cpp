#include "core/document/document.h"

#include "core/curve/limits.h"
#include "core/curve/text/utf8.h"

#include <algorithm>
#include <utility>

namespace kriva {
namespace {

template <std::size_t... Index>
std::array<Curve, kSheetCount> emptyCurves(std::index_sequence<Index...>) {
    return {Curve(std::in_place_index<Index>)...};
}

/// One empty curve of each kind, to ask a sheet's folder what does not depend on a curve.
const std::array<Curve, kSheetCount>& kinds() {
    static const std::array<Curve, kSheetCount> curves = emptyCurves(std::make_index_sequence<kSheetCount>());
    return curves;
}

template <class C>
Edited<Curve> widened(Edited<C> edited) {
    return {Curve(std::move(edited.curve)), std::move(edited.map)};
}

/// The layer with the marks that such grips are taken hold of by.
std::string_view layerOf(GripKind kind, const Curve& curve) {
    switch (kind) {
    case GripKind::point:
        return std::holds_alternative<SplineCurve>(curve) ? "knots" : "points";
    case GripKind::inHandle:
    case GripKind::outHandle:
    case GripKind::inner:
        return "handles";
    case GripKind::middle:
        return "middle-points";
    case GripKind::startDerivative:
    case GripKind::endDerivative:
        return "end-derivatives";
    }
    return {};
}

bool sameContent(const Curve& a, const Curve& b) {
    return viewOf(a) == viewOf(b) ? a == b : withView(a, viewOf(b)) == b;
}

} // namespace

std::string_view sheetName(SheetIndex sheet) {
    return std::visit([](const auto& curve) { return curve.kSheet; }, kinds()[sheet]);
}

std::optional<SheetIndex> sheetNamed(std::string_view name) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        if (sheetName(sheet) == name)
            return sheet;
    return {};
}

Caption captionOf(SheetIndex sheet) {
    return std::visit([](const auto& curve) { return curve.kCaption; }, kinds()[sheet]);
}

Curve emptyCurve(SheetIndex sheet) {
    return kinds()[sheet];
}

bool sameContent(const Document& a, const Document& b) {
    const auto sameCurves = [](const Sheet& x, const Sheet& y) {
        return std::equal(x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
                          [](const Curve& c, const Curve& d) { return sameContent(c, d); });
    };
    return a.title == b.title && std::equal(a.sheets.begin(), a.sheets.end(), b.sheets.begin(), sameCurves);
}

const std::string& nameOf(const Curve& curve) {
    return std::visit([](const auto& c) -> const std::string& { return c.name; }, curve);
}

Curve renamed(Curve curve, std::string_view name) {
    std::visit([&](auto& c) { c.name = asUtf8(name); }, curve);
    return curve;
}

const CurveView& viewOf(const Curve& curve) {
    return std::visit([](const auto& c) -> const CurveView& { return c.view; }, curve);
}

Curve withView(Curve curve, CurveView view) {
    std::visit([&](auto& c) { c.view = view; }, curve);
    return curve;
}

const CurveStyle& styleOf(const Curve& curve) {
    return std::visit([](const auto& c) -> const CurveStyle& { return c.style; }, curve);
}

Curve withStyle(Curve curve, CurveStyle style) {
    std::visit([&](auto& c) { c.style = style; }, curve);
    return curve;
}

bool isIncomplete(const Curve& curve) {
    return std::visit([](const auto& c) { return isIncomplete(c); }, curve);
}

std::size_t pointCount(const Curve& curve) {
    return std::visit([](const auto& c) { return pointCount(c); }, curve);
}

Point pointAt(const Curve& curve, int index) {
    return std::visit([&](const auto& c) { return pointAt(c, index); }, curve);
}

std::size_t derivedPointCount(const Curve& curve) {
    return std::visit([](const auto& c) { return derivedPointCount(c); }, curve);
}

std::size_t mostPoints(const Curve& curve) {
    return std::visit([](const auto& c) { return mostPoints(c); }, curve);
}

bool isWithin(const Curve& curve, double limit) {
    return std::visit([&](const auto& c) { return isWithin(c, limit); }, curve);
}

std::vector<Grip> grips(const Curve& curve) {
    return std::visit([](const auto& c) { return grips(c); }, curve);
}

Curve withGripsMoved(const Curve& curve, std::span<const GripId> ids, Vector by) {
    return std::visit([&](const auto& c) { return Curve(withGripsMoved(c, ids, by)); }, curve);
}

Edited<Curve> withPointAdded(Curve curve, Point at) {
    return std::visit([&](auto& c) { return widened(withPointAdded(std::move(c), at)); }, curve);
}

Curve withPointsAdded(Curve curve, std::span<const Point> points) {
    return std::visit([&](auto& c) { return Curve(withPointsAdded(std::move(c), points)); }, curve);
}

Curve withPathAdded(Curve curve, const Path& path) {
    return std::visit([&](auto& c) { return Curve(withPathAdded(std::move(c), path)); }, curve);
}

Curve appended(Curve curve, const Curve& other) {
    return std::visit([&]<class C>(C& c) { return Curve(appended(std::move(c), std::get<C>(other))); }, curve);
}

std::optional<Edited<Curve>> withPointInserted(const Curve& curve, Point near) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Edited<Curve>> {
            std::optional<Edited<C>> edited = withPointInserted(c, near); // its own, not this function once more
            if (!edited)
                return {};
            return widened(std::move(*edited));
        },
        curve);
}

std::optional<Curve> withCurvePulled(const Curve& curve, Point from, Vector by) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Curve> {
            std::optional<C> pulled = withCurvePulled(c, from, by);
            return pulled;
        },
        curve);
}

Edited<Curve> withPointsRemoved(const Curve& curve, const std::vector<int>& indices) {
    return std::visit([&](const auto& c) { return widened(withPointsRemoved(c, indices)); }, curve);
}

Refitted<Curve> withPointsRemovedRefitted(const Curve& curve, const std::vector<int>& indices) {
    return std::visit(
        [&](const auto& c) {
            auto refitted = withPointsRemovedRefitted(c, indices);
            return Refitted<Curve>{widened(std::move(refitted.edited)), refitted.deviation};
        },
        curve);
}

std::optional<int> polynomialDegree(const Curve& curve) {
    return std::visit([](const auto& c) { return polynomialDegree(c); }, curve);
}

Edited<Curve> reversed(const Curve& curve) {
    return std::visit([](const auto& c) { return widened(reversed(c)); }, curve);
}

std::span<const LayerInfo> layersOf(SheetIndex sheet) {
    return std::visit([](const auto& c) { return layersOf(c); }, kinds()[sheet]);
}

Figure figureOf(const Curve& curve, const FigureContext& context) {
    return styled(std::visit([&](const auto& c) { return figureOf(c, context); }, curve), styleOf(curve));
}

std::optional<DrawnCurve> drawn(const Curve& curve, const FigureContext& context, WorkBudget& budget) {
    std::optional<DrawnCurve> all = std::visit([&](const auto& c) { return drawn(c, context, budget); }, curve);
    if (!all)
        return {};
    const std::span<const LayerInfo> layers = layersOf(curve.index());
    all->figure = shownLayers(styled(std::move(all->figure), styleOf(curve)), layers, context);
    std::vector<GripKind> hidden; // asked once for each kind: a curve may have as many grips as points
    for (const GripKind kind : kGripKinds)
        if (!isDrawn(layerOf(kind, curve), layers, context))
            hidden.push_back(kind);
    if (!hidden.empty())
        std::erase_if(all->grips,
                      [&](const Grip& grip) { return std::ranges::find(hidden, grip.id.kind) != hidden.end(); });
    return all;
}

DrawnCurve drawnPoints(const Curve& curve, const FigureContext& context) {
    const std::string_view layer = layerOf(GripKind::point, curve);
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

std::optional<std::vector<Result>> results(const Curve& curve, WorkBudget& budget) {
    return std::visit([&](const auto& c) { return results(c, budget); }, curve);
}

std::vector<Result> results(const Curve& curve) {
    return withoutLimit([&](WorkBudget& budget) { return results(curve, budget); });
}

std::optional<Relations> relationsOf(std::span<const Curve* const> curves, SheetIndex index, WorkBudget& budget) {
    return std::visit(
        [&]<class C>(const C&) -> std::optional<Relations> {
            if constexpr (requires(std::span<const C* const> ofKind) { relationsOf(ofKind, budget); }) {
                std::vector<const C*> ofKind(curves.size());
                std::ranges::transform(curves, ofKind.begin(), [](const Curve* curve) { return &std::get<C>(*curve); });
                return relationsOf(std::span<const C* const>(ofKind), budget);
            } else {
                return Relations();
            }
        },
        kinds()[index]);
}

std::optional<Relations> relationsOf(const Sheet& sheet, SheetIndex index, WorkBudget& budget) {
    std::vector<const Curve*> curves(sheet.curves.size());
    std::ranges::transform(sheet.curves, curves.begin(), [](const Curve& curve) { return &curve; });
    return relationsOf(curves, index, budget);
}

Relations relationsOf(const Sheet& sheet, SheetIndex index) {
    WorkBudget budget(limits::kSteps);
    return *relationsOf(sheet, index, budget); // nobody stops it
}

std::optional<Sheet> atFrame(Sheet sheet, const FramePlace& place) {
    if (sheet.curves.empty())
        return {};
    Curve& active = sheet.curves[static_cast<std::size_t>(sheet.view.activeCurve)];
    const auto frame = std::visit(
        [&](const auto& curve) -> std::optional<Frame<Curve>> {
            auto found = atFrame(curve, place);
            return found ? std::optional(Frame<Curve>{Curve(std::move(found->curve)), found->layerStage})
                         : std::nullopt;
        },
        active);
    if (!frame)
        return {};
    active = frame->curve;
    sheet.stage = frame->layerStage;
    return sheet;
}

FigureContext contextOf(const Sheet& sheet, int curve) {
    const bool isActive = curve == sheet.view.activeCurve;
    return {curve, isActive, &sheet.view, isActive ? sheet.stage : std::nullopt};
}

Figure figureOfCurves(const Sheet& sheet, SheetIndex index) {
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < sheet.curves.size(); ++i) {
        if (!viewOf(sheet.curves[i]).isShown)
            continue;
        const FigureContext context = contextOf(sheet, static_cast<int>(i));
        figures.push_back(shownLayers(figureOf(sheet.curves[i], context), layersOf(index), context));
    }
    return united(std::move(figures), layersOf(index));
}

Figure figureOf(const Sheet& sheet, SheetIndex index) {
    WorkBudget budget(limits::kSteps);
    return figureOf(sheet, index, shownRelations(sheet, index, budget));
}

Figure figureOf(const Sheet& sheet, SheetIndex index, const Relations& relations) {
    const std::span<const LayerInfo> layers = layersOf(index);
    if (relations.figure.layers.empty())
        return figureOfCurves(sheet, index);
    return united({figureOfCurves(sheet, index), shownLayers(relations.figure, layers, {.view = &sheet.view})}, layers);
}

Relations shownRelations(const Sheet& sheet, SheetIndex index, WorkBudget& budget) {
    const bool areShown = std::ranges::any_of(
        layersOf(index), [&](const LayerInfo& layer) { return layer.isOfSheet && isShown(layer, sheet.view); });
    return areShown ? relationsOf(sheet, index, budget).value_or(Relations()) : Relations(); // they may take seconds
}

} // namespace kriva
