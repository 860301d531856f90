#include "core/curve/limits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"

#include <algorithm>

namespace kriva {
namespace {

using Join = SplineKnot::Join;

int countOf(const SplineCurve& curve) {
    return static_cast<int>(curve.knots.size());
}

/// The inner points where an index map takes their segments. A segment goes on where its two knots stay neighbours; in
/// the other order it is run through backwards, and its points are too.
std::map<int, Points> followed(const SplineCurve& old, const IndexMap& map, int newCount) {
    const auto goesOn = [&](int from, int to) {
        return to == from + 1 || (old.closed && from == newCount - 1 && to == 0);
    };
    std::map<int, Points> inner;
    for (const auto& [segment, points] : old.inner) {
        if (static_cast<std::size_t>(segment) >= segmentCount(old))
            continue;
        const int from = map(segment);
        const int to = map((segment + 1) % countOf(old));
        if (from == IndexMap::kGone || to == IndexMap::kGone)
            continue;
        if (goesOn(from, to))
            inner.emplace(from, points);
        else if (goesOn(to, from))
            inner.emplace(to, Points(points.rbegin(), points.rend()));
    }
    return inner;
}

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

/// Stores every handle that the mirror rule placed: at automatic knots it mirrors them.
SplineCurve withMirrorFrozen(const SplineCurve& curve) {
    if (curve.rule != SplineCurve::Rule::mirror)
        return curve;
    std::vector<int> automatic;
    for (int i = 0; i < countOf(curve); ++i)
        if (isAutomatic(curve.knots[static_cast<std::size_t>(i)]))
            automatic.push_back(i);
    return withJoin(curve, automatic, Join::symmetric);
}

/// The map of a closed chain that keeps its first knot when it is turned round.
IndexMap mapTurned(int count) {
    IndexMap map;
    for (int old = 0; old < count; ++old)
        map.newIndex.push_back(old == 0 ? 0 : count - old);
    return map;
}

} // namespace

std::vector<Grip> grips(const SplineCurve& curve) {
    std::vector<Grip> all;
    const std::vector<KnotHandles> handles = knotHandles(curve);
    all.reserve(3 * curve.knots.size());
    for (int i = 0; i < countOf(curve); ++i)
        all.push_back({{GripKind::point, i}, curve.knots[static_cast<std::size_t>(i)].at});
    for (int i = 0; i < countOf(curve); ++i) {
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

bool isWithin(const SplineCurve& curve, double limit) {
    const auto isFine = [limit](std::optional<Point> p) { return !p || isWithin(*p, limit); };
    const auto isFineTip = [&](std::optional<Vector> v) { return !v || isWithin(Point{} + *v, limit); };
    return std::ranges::all_of(curve.knots,
                               [&](const SplineKnot& knot) {
                                   return isWithin(knot.at, limit) && isFine(knot.in) && isFine(knot.out);
                               }) &&
           std::ranges::all_of(curve.inner, [&](const auto& inner) { return areWithin(inner.second, limit); }) &&
           isFineTip(curve.startDerivative) && isFineTip(curve.endDerivative);
}

std::optional<FileError> pointLimitError(const SplineCurve& curve) {
    return pointCountError(curve.knots.size(), limits::kPointsInCurve);
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

Edited<SplineCurve> withPointAdded(SplineCurve curve, Point at) {
    return {withPointsAdded(std::move(curve), std::span(&at, 1)), {}};
}

SplineCurve withPointsAdded(SplineCurve curve, std::span<const Point> points) {
    SplineCurve added;
    for (const Point at : points)
        added.knots.push_back({at, Join::automatic, {}, {}});
    return appended(std::move(curve), added);
}

SplineCurve appended(SplineCurve curve, const SplineCurve& other) {
    if (other.knots.empty())
        return curve;
    const int count = countOf(curve);
    if (curve.closed) // the closing segment goes, and another comes
        curve.inner.erase(count - 1);
    if (curve.degree == other.degree)
        for (const auto& [segment, points] : other.inner)
            if (segment + 1 < countOf(other))
                curve.inner.emplace(count + segment, points);
    curve.knots.insert(curve.knots.end(), other.knots.begin(), other.knots.end());
    return repaired(std::move(curve));
}

Edited<SplineCurve> withPointsRemoved(const SplineCurve& curve, const std::vector<int>& indices) {
    Edited<SplineCurve> edited{curve, mapWithout(countOf(curve), indices)};
    edited.curve.knots = without(curve.knots, indices);
    edited.curve.inner = followed(curve, edited.map, countOf(edited.curve));
    edited.curve = repaired(std::move(edited.curve));
    return edited;
}

Edited<SplineCurve> reversed(const SplineCurve& curve) {
    const int count = countOf(curve);
    Edited<SplineCurve> edited{withMirrorFrozen(curve), curve.closed ? mapTurned(count) : mapReversed(count)};
    std::ranges::reverse(edited.curve.knots);
    if (curve.closed && count > 0)
        std::ranges::rotate(edited.curve.knots, edited.curve.knots.end() - 1);
    for (SplineKnot& knot : edited.curve.knots)
        std::swap(knot.in, knot.out);
    const auto negated = [](std::optional<Vector> v) { return v ? std::optional(-*v) : std::nullopt; };
    edited.curve.startDerivative = negated(curve.endDerivative);
    edited.curve.endDerivative = negated(curve.startDerivative);
    edited.curve.inner = followed(curve, edited.map, count);
    return edited;
}

} // namespace kriva
