#include "ui/canvas/canvas_curves.h"

#include <QGraphicsScene>

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

// Steps to what can be drawn: large ones down, since a frame waits for them, small ones back.
constexpr int kFirstStep = 4;
constexpr int kStep = 2;
// A frame with less than this part of what is possible has room for twice as much.
constexpr double kRoomy = 0.4;

} // namespace

void CanvasCurves::set(std::vector<CanvasCurve> curves) {
    std::vector<Entry> before = std::exchange(entries_, {});
    entries_.reserve(curves.size());
    for (CanvasCurve& curve : curves) {
        Entry& entry = entries_.emplace_back(entryFor(curve, before));
        scene_.addItem(entry.item); // in the order of the curves
        fill(entry, std::move(curve));
    }
    for (const Entry& gone : before)
        delete gone.item;
}

/// The one that is there where its figure is to stay, which is taken from the scene; else a new one with the figure.
CanvasCurves::Entry CanvasCurves::entryFor(const CanvasCurve& curve, std::vector<Entry>& before) {
    const auto same = curve.isFigureDue ? std::ranges::find(before, curve.serial, &Entry::serial) : before.end();
    if (same == before.end()) {
        Entry entry;
        entry.serial = curve.serial;
        entry.item = new FigureItem;
        entry.item->setFigure(curve.figure);
        return entry;
    }
    Entry entry = std::move(*same);
    before.erase(same);
    scene_.removeItem(entry.item);
    return entry;
}

void CanvasCurves::update(CanvasCurve curve) {
    const auto entry = std::ranges::find(entries_, curve.serial, &Entry::serial);
    if (entry != entries_.end())
        fill(*entry, std::move(curve));
}

void CanvasCurves::fill(Entry& entry, CanvasCurve curve) {
    entry.name = std::move(curve.name);
    entry.grips = std::move(curve.grips);
    entry.isActive = curve.isActive;
    entry.item->setZValue(curve.isOnTop ? 2 : entry.isActive ? 1 : 0);
    if (curve.isFigureDue)
        return;
    entry.isPrepared = false;
    entry.box = curve.box;
    entry.item->setFigure(std::move(curve.figure));
}

void CanvasCurves::invalidate() {
    for (Entry& entry : entries_)
        entry.isPrepared = false;
}

Box CanvasCurves::prepare(Sight& sight) {
    choose(sight);
    Box changed;
    for (Entry& entry : entries_)
        if (!std::exchange(entry.isSettled, true))
            changed = united(changed, entry.item->settle());
    return changed;
}

void CanvasCurves::choose(Sight& sight) {
    bool wentFiner = false;
    bool wentTooFar = false;
    for (;;) {
        const FrameLoad load = prepareStale(sight);
        const Fineness now = sight.fineness;
        if (load.isTooMuch()) {
            wentTooFar = wentFiner;
            sight.fineness = coarser(now, load, wentFiner ? kStep : kFirstStep);
        } else if (!wentTooFar && load.part() < kRoomy) {
            wentFiner = true;
            sight.fineness = finer(now);
        }
        if (sight.fineness == now)
            return;
        invalidate();
    }
}

/// What there is to paint, where it is too much only the first of it.
FrameLoad CanvasCurves::prepareStale(const Sight& sight) {
    FrameLoad load;
    for (const Entry& entry : entries_)
        if (entry.isPrepared)
            load += entry.item->load();
    for (Entry& entry : entries_) {
        if (!entry.isPrepared)
            entry.item->prepare(sight, pictures_, load);
        entry.isSettled = entry.isSettled && entry.isPrepared;
        entry.isPrepared = true;
    }
    return load;
}

std::vector<HitTarget> CanvasCurves::targets() const {
    std::vector<HitTarget> found;
    found.reserve(entries_.size());
    for (const Entry& entry : entries_)
        found.push_back(
            {entry.serial, entry.isActive, entry.grips, entry.item->curveLines(), entry.item->figure().layers});
    return found;
}

std::vector<SnapTarget> CanvasCurves::snapTargets() const {
    std::vector<SnapTarget> found;
    found.reserve(entries_.size());
    for (const Entry& entry : entries_)
        found.push_back({entry.serial, entry.grips, &entry.item->figure()});
    return found;
}

std::vector<GripRef> CanvasCurves::points() const {
    std::vector<GripRef> found;
    for (const Entry& entry : entries_)
        for (const Grip& grip : entry.grips)
            if (grip.id.kind == GripKind::point)
                found.push_back({entry.serial, grip.id});
    return found;
}

std::optional<Point> CanvasCurves::placeOf(const GripRef& grip) const {
    const auto entry = std::ranges::find(entries_, grip.serial, &Entry::serial);
    if (entry == entries_.end())
        return std::nullopt;
    // Points come first, in their order.
    const auto index = static_cast<std::size_t>(grip.id.index);
    if (index < entry->grips.size() && entry->grips[index].id == grip.id)
        return entry->grips[index].at;
    const auto found = std::ranges::find(entry->grips, grip.id, &Grip::id);
    return found == entry->grips.end() ? std::nullopt : std::optional(found->at);
}

Points CanvasCurves::placesOf(const Selection& selection) const {
    Points places;
    for (const GripRef& grip : selection)
        if (const auto place = placeOf(grip))
            places.push_back(*place);
    return places;
}

Box CanvasCurves::box() const {
    Box all;
    for (const Entry& entry : entries_) {
        all = united(all, entry.boxOfFigure());
        for (const Grip& grip : entry.grips)
            extend(all, grip.at);
    }
    return all;
}

Box CanvasCurves::boxOfFigures() const {
    Box all;
    for (const Entry& entry : entries_)
        if (entry.serial != 0)
            all = united(all, entry.boxOfFigure());
    return all;
}

std::vector<CanvasCurves::Named> CanvasCurves::named() const {
    std::vector<Named> found;
    for (const Entry& entry : entries_)
        if (!entry.grips.empty())
            found.push_back({entry.serial, entry.name,
                             static_cast<int>(std::ranges::count(entry.grips, GripKind::point,
                                                                 [](const Grip& grip) { return grip.id.kind; }))});
    return found;
}

} // namespace kriva::ui
