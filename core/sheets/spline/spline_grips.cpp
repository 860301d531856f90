#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>

namespace kriva {
namespace {

/// What moves when grips are dragged together.
class Carried {
  public:
    Carried(const SplineCurve& curve, std::span<const GripId> ids)
        : knots_(curve.knots.size()) {
        for (const GripId& id : ids)
            if (id.kind == GripKind::point && static_cast<std::size_t>(id.index) < knots_.size())
                knots_[static_cast<std::size_t>(id.index)] = true;
    }
    [[nodiscard]] bool hasKnot(std::size_t i) const { return knots_[i]; }
    [[nodiscard]] bool hasSegment(std::size_t i) const { return knots_[i] && knots_[(i + 1) % knots_.size()]; }

  private:
    std::vector<bool> knots_;
};

void carry(SplineCurve& curve, const Carried& carried, Vector by) {
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
        if (!carried.hasKnot(i))
            continue;
        SplineKnot& knot = curve.knots[i];
        knot.at = knot.at + by;
        for (std::optional<Point>* handle : {&knot.in, &knot.out})
            if (*handle)
                *handle = **handle + by;
    }
    for (auto& [segment, points] : curve.inner)
        if (static_cast<std::size_t>(segment) < segmentCount(curve) &&
            carried.hasSegment(static_cast<std::size_t>(segment)))
            for (Point& p : points)
                p = p + by;
}

/// Moves handles, inner points and end derivatives, each from where it stood before the edit.
class GripMover {
  public:
    GripMover(const SplineCurve& before, const Carried& carried, Vector by)
        : carried_(carried)
        , by_(by)
        , handles_(knotHandles(before))
        , ends_(endDerivatives(before, handles_)) {
        if (innerCount(before.degree) > 0)
            segments_ = segmentsOf(before);
    }

    void move(SplineCurve& curve, const GripId& id) const {
        const auto i = static_cast<std::size_t>(id.index);
        if (id.kind == GripKind::inHandle && i < handles_.size())
            moveHandle(curve, i, HandleSide::in, handles_[i].in);
        else if (id.kind == GripKind::outHandle && i < handles_.size())
            moveHandle(curve, i, HandleSide::out, handles_[i].out);
        else if (id.kind == GripKind::inner && i < segments_.size() && !carried_.hasSegment(i))
            moveInner(curve, id);
        else if (id.kind == GripKind::startDerivative && ends_.start && !carried_.hasKnot(0))
            curve.startDerivative = *ends_.start + by_;
        else if (id.kind == GripKind::endDerivative && ends_.end && !carried_.hasKnot(curve.knots.size() - 1))
            curve.endDerivative = *ends_.end + by_;
    }

  private:
    void moveHandle(SplineCurve& curve, std::size_t i, HandleSide side, std::optional<Point> from) const {
        if (from && !carried_.hasKnot(i))
            curve.knots[i] = withHandleAt(curve.knots[i], side, *from + by_);
    }

    void moveInner(SplineCurve& curve, const GripId& id) const {
        const auto part = static_cast<std::size_t>(id.part);
        if (part >= innerCount(curve.degree))
            return;
        const Points standing = innerOf(segments_[static_cast<std::size_t>(id.index)]);
        Points& inner = curve.inner.try_emplace(id.index, standing).first->second;
        inner[part] = standing[part] + by_;
    }

    const Carried& carried_;
    Vector by_;
    std::vector<KnotHandles> handles_;
    EndDerivatives ends_;
    std::vector<Points> segments_; ///< of degrees 4 and 5
};

} // namespace

std::vector<Grip> grips(const SplineCurve& curve) {
    std::vector<Grip> all;
    const std::vector<KnotHandles> handles = knotHandles(curve);
    all.reserve(3 * curve.knots.size());
    for (int i = 0; i < std::ssize(curve.knots); ++i)
        all.push_back({{GripKind::point, i}, curve.knots[static_cast<std::size_t>(i)].at});
    for (int i = 0; i < std::ssize(curve.knots); ++i) {
        const KnotHandles& both = handles[static_cast<std::size_t>(i)];
        if (both.in)
            all.push_back({{GripKind::inHandle, i}, *both.in});
        if (both.out)
            all.push_back({{GripKind::outHandle, i}, *both.out});
    }
    if (innerCount(curve.degree) > 0)
        for (int segment = 0; const Points& polygon : segmentsOf(curve)) {
            for (int part = 0; const Point p : innerOf(polygon))
                all.push_back({{GripKind::inner, segment, part++}, p});
            ++segment;
        }
    const EndDerivatives ends = endDerivatives(curve, handles);
    if (ends.start)
        all.push_back({{GripKind::startDerivative}, curve.knots.front().at + *ends.start});
    if (ends.end)
        all.push_back({{GripKind::endDerivative}, curve.knots.back().at + *ends.end});
    return all;
}

std::string_view layerOf(const SplineCurve&, GripKind kind) {
    switch (kind) {
    case GripKind::point:
        return "knots";
    case GripKind::startDerivative:
    case GripKind::endDerivative:
        return "end-derivatives";
    case GripKind::inHandle:
    case GripKind::outHandle:
    case GripKind::inner:
    case GripKind::middle:
        break;
    }
    return "handles";
}

SplineCurve withGripsMoved(const SplineCurve& curve, std::span<const GripId> ids, Vector by) {
    SplineCurve moved = curve;
    const Carried carried(curve, ids);
    carry(moved, carried, by);
    const bool areAllKnots = std::ranges::all_of(ids, [](const GripId& id) { return id.kind == GripKind::point; });
    if (areAllKnots)
        return moved;
    const GripMover mover(curve, carried, by);
    for (const GripId& id : ids)
        mover.move(moved, id);
    return moved;
}

} // namespace kriva
