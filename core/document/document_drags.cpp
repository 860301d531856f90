#include "core/document/document_drags.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace kriva {
namespace {

template <class C>
std::optional<Curve> widened(std::optional<C> curve) {
    return curve ? std::optional(Curve(*std::move(curve))) : std::nullopt;
}

} // namespace

bool hasHandles(const Curve& curve) {
    return std::visit(
        []<class C>(const C& c) {
            if constexpr (C::kCapabilities.handles)
                return pullsHandles(c);
            else
                return false;
        },
        curve);
}

PulledPoint readyToPull(const Curve& curve, int point) {
    return std::visit(
        [&]<class C>(const C& c) -> PulledPoint {
            if constexpr (C::kCapabilities.handles)
                if (std::optional<C> ready = readyToPull(c, point))
                    return {Curve(std::move(*ready)), {GripKind::outHandle, point}};
            return {Curve(c), {GripKind::point, point}};
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
            if constexpr (C::kCapabilities.handles)
                return Curve(withHandleDragged(c, id, way));
            else
                return Curve(withGripsMoved(c, std::span(&id, 1), way.by));
        },
        curve);
}

std::optional<Curve> withHandleRetracted(const Curve& curve, const GripId& id) {
    return std::visit(
        [&]<class C>(const C& c) -> std::optional<Curve> {
            if constexpr (C::kCapabilities.handles)
                return widened(withHandleRetracted(c, id));
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
            if constexpr (C::kCapabilities.closing)
                return widened(closedAt(c, point));
            else
                return {};
        },
        curve);
}

} // namespace kriva
