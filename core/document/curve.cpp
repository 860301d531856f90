#include "core/document/curve.h"

#include "core/curve/text/utf8.h"

#include <array>
#include <utility>

namespace kriva {
namespace {

template <std::size_t... Index>
std::array<Curve, kSheetCount> emptyCurves(std::index_sequence<Index...>) {
    return {Curve(std::variant_alternative_t<Index, CurveKinds>())...};
}

template <class C>
Edited<Curve> widened(Edited<C> edited) {
    return {Curve(std::move(edited.curve)), std::move(edited.map)};
}

} // namespace

const Curve& emptyCurve(SheetIndex sheet) {
    static const std::array<Curve, kSheetCount> curves = emptyCurves(std::make_index_sequence<kSheetCount>());
    return curves[sheet];
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

std::optional<FileError> pointLimitError(const Curve& curve) {
    return std::visit([](const auto& c) { return pointLimitError(c); }, curve);
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
    return std::visit(
        [&]<class C>(C& c) {
            if constexpr (C::kCapabilities.pieces)
                return Curve(withPathAdded(std::move(c), path));
            else
                return Curve(withPointsAdded(std::move(c), pointsOf(path)));
        },
        curve);
}

Curve appended(Curve curve, const Curve& other) {
    return std::visit([&]<class C>(C& c) { return Curve(appended(std::move(c), std::get<C>(other))); }, curve);
}

std::optional<Edited<Curve>> withPointInserted(const Curve& curve, Point near) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Edited<Curve>> {
            std::optional<Edited<C>> edited = withPointInserted(c, near);
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
            if (!pulled)
                return {};
            return Curve(std::move(*pulled));
        },
        curve);
}

Edited<Curve> withPointsRemoved(const Curve& curve, const std::vector<int>& indices) {
    return std::visit([&](const auto& c) { return widened(withPointsRemoved(c, indices)); }, curve);
}

Refitted<Curve> withPointsRemovedRefitted(const Curve& curve, const std::vector<int>& indices) {
    return std::visit(
        [&]<class C>(const C& c) -> Refitted<Curve> {
            if constexpr (C::kCapabilities.pieces) {
                Refitted<C> refitted = withPointsRemovedRefitted(c, indices);
                return {widened(std::move(refitted.edited)), refitted.deviation};
            } else {
                return {widened(withPointsRemoved(c, indices)), {}};
            }
        },
        curve);
}

std::optional<int> polynomialDegree(const Curve& curve) {
    return std::visit([](const auto& c) { return polynomialDegree(c); }, curve);
}

Edited<Curve> reversed(const Curve& curve) {
    return std::visit([](const auto& c) { return widened(reversed(c)); }, curve);
}

std::optional<std::vector<Result>> results(const Curve& curve, WorkBudget& budget) {
    return std::visit([&](const auto& c) { return results(c, budget); }, curve);
}

std::vector<Result> results(const Curve& curve) {
    return withoutLimit([&](WorkBudget& budget) { return results(curve, budget); });
}

std::optional<std::vector<PlotGroup>> plotsOf(const Curve& curve, WorkBudget& budget) {
    return std::visit([&](const auto& c) { return plotsOf(c, budget); }, curve);
}

std::optional<std::vector<Table>> tablesOf(const Curve& curve, WorkBudget& budget) {
    return std::visit([&](const auto& c) { return tablesOf(c, budget); }, curve);
}

} // namespace kriva
