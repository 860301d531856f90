#include "core/document/document_drags.h"

#include <algorithm>
#include <concepts>
#include <limits>

namespace kriva {

bool hasHandles(const Curve& curve) {
    return std::visit(
        [](const auto& c) {
            if constexpr (requires { pullsHandles(c); })
                return pullsHandles(c);
            else
                return false;
        },
        curve);
}

PulledPoint readyToPull(const Curve& curve, int point) {
    return std::visit(
        [&]<class C>(const C& c) -> PulledPoint {
            if constexpr (requires {
                              { readyToPull(c, point) } -> std::same_as<std::optional<C>>;
                          })
                if (auto ready = readyToPull(c, point))
                    return {std::move(*ready), {GripKind::outHandle, point}};
            return {c, {GripKind::point, point}};
        },
        curve);
}

bool isHandle(GripKind kind) {
    return kind == GripKind::inHandle || kind == GripKind::outHandle || kind == GripKind::startDerivative ||
           kind == GripKind::endDerivative;
}

std::optional<Vector> oppositeHandle(const Curve& curve, const GripId& handle) {
    if (handle.kind != GripKind::inHandle && handle.kind != GripKind::outHandle)
        return {};
    const GripId opposite{handle.kind == GripKind::inHandle ? GripKind::outHandle : GripKind::inHandle, handle.index};
    const std::vector<Grip> all = grips(curve);
    const auto found = std::ranges::find(all, opposite, &Grip::id);
    return found == all.end() ? std::nullopt : std::optional(found->at - pointAt(curve, handle.index));
}

Curve withHandleDragged(const Curve& curve, const GripId& id, const HandleWay& way) {
    return std::visit(
        [&]<class C>(const C& c) -> Curve {
            if constexpr (requires {
                              { withHandleDragged(c, id, way) } -> std::same_as<C>;
                          })
                return withHandleDragged(c, id, way);
            else
                return withGripsMoved(c, std::span(&id, 1), way.by);
        },
        curve);
}

std::optional<Curve> withHandleRetracted(const Curve& curve, const GripId& id) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Curve> {
            if constexpr (requires {
                              { withHandleRetracted(c, id) } -> std::same_as<std::optional<C>>;
                          })
                return withHandleRetracted(c, id);
            else
                return {};
        },
        curve);
}

std::optional<Edited<Curve>> withPointInsertedBehind(const Curve& curve, std::optional<int> point) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Edited<Curve>> {
            std::optional<Edited<C>> edited = withPointInsertedBehind(c, point);
            if (!edited)
                return {};
            return Edited<Curve>{Curve(std::move(edited->curve)), std::move(edited->map)};
        },
        curve);
}

int newPointNear(const Edited<Curve>& inserted, Point near) {
    std::vector<bool> isOld(pointCount(inserted.curve));
    for (const int index : inserted.map.newIndex)
        if (index != IndexMap::kGone)
            isOld[static_cast<std::size_t>(index)] = true;
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(isOld.size()); ++i) {
        const double away = distance(pointAt(inserted.curve, i), near);
        if (isOld[static_cast<std::size_t>(i)] || away >= least)
            continue;
        least = away;
        nearest = i;
    }
    return nearest;
}

std::optional<Curve> closedAt(const Curve& curve, int point) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Curve> {
            if constexpr (requires {
                              { closedAt(c, point) } -> std::same_as<std::optional<C>>;
                          })
                return closedAt(c, point);
            else
                return {};
        },
        curve);
}

} // namespace kriva
