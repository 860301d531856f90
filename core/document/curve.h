#pragma once

#include "core/curve/sheet.h"
#include "core/document/sheet_list.h"

#include <type_traits>
#include <utility>

namespace kriva {

template <class... C>
consteval bool areSheets(std::type_identity<std::variant<C...>>) {
    return (isSheet<C>() && ...);
}
static_assert(areSheets(std::type_identity<CurveKinds>()));

template <class C, class Kinds>
inline constexpr bool kIsAmong = false;
template <class C, class... Kinds>
inline constexpr bool kIsAmong<C, std::variant<Kinds...>> = (std::same_as<C, Kinds> || ...);

/// A curve of any sheet. None becomes one unless it is asked for, so that a function of this kind of curve can never
/// stand in for one that a sheet does not have.
class Curve : public CurveKinds {
  public:
    Curve() = default;
    template <class C>
    requires kIsAmong<C, CurveKinds>
    explicit Curve(C curve)
        : CurveKinds(std::move(curve)) {}
};

/// Which sheet: the index of its kind of curve.
using SheetIndex = std::size_t;
inline constexpr SheetIndex kSheetCount = std::variant_size_v<CurveKinds>;

template <class C, class... Kinds>
consteval SheetIndex placeAmong(std::type_identity<std::variant<Kinds...>>) {
    SheetIndex place = 0;
    (void)((std::same_as<C, Kinds> || (++place, false)) || ...);
    return place;
}
/// The sheet of a kind of curve.
template <class C>
requires kIsAmong<C, CurveKinds>
inline constexpr SheetIndex kSheetOf = placeAmong<C>(std::type_identity<CurveKinds>());

/// A curve of the sheet's kind without points.
[[nodiscard]] const Curve& emptyCurve(SheetIndex sheet);

// What every kind of curve can do, for those that do not care about the kind. See sheet.h for each.
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
[[nodiscard]] std::optional<FileError> pointLimitError(const Curve& curve);
[[nodiscard]] bool isWithin(const Curve& curve, double limit);
[[nodiscard]] std::vector<Grip> grips(const Curve& curve);
[[nodiscard]] Curve withGripsMoved(const Curve& curve, std::span<const GripId> ids, Vector by);
/// By value, so that adding many to a moved curve copies nothing.
[[nodiscard]] Edited<Curve> withPointAdded(Curve curve, Point at);
[[nodiscard]] Curve withPointsAdded(Curve curve, std::span<const Point> points);
/// A path behind its own points: curves made of pieces take its pieces as they are, the others its points.
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
/// The degree where one polynomial runs through all points, so that it falls when one is removed.
[[nodiscard]] std::optional<int> polynomialDegree(const Curve& curve);
[[nodiscard]] Edited<Curve> reversed(const Curve& curve);
[[nodiscard]] std::optional<std::vector<Result>> results(const Curve& curve, WorkBudget& budget);
[[nodiscard]] std::vector<Result> results(const Curve& curve);
[[nodiscard]] std::optional<std::vector<PlotGroup>> plotsOf(const Curve& curve, WorkBudget& budget);
[[nodiscard]] std::optional<std::vector<Table>> tablesOf(const Curve& curve, WorkBudget& budget);

} // namespace kriva
