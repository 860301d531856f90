#include "ui/editing/sheet/shown_sheet.h"

#include <algorithm>

namespace kriva::ui {

ShownSheet::ShownSheet(OpenDocument& document, QThreadPool& workers, SheetIndex sheet, QObject* parent)
    : QObject(parent)
    , document_(document)
    , workers_(workers)
    , index_(sheet) {
    connect(&document, &OpenDocument::curveChanged, this, [this](SheetIndex changed, Serial serial) {
        if (changed != index_)
            return;
        if (serial == stagedSerial_)
            stage_.reset(); // it shows what was before
        dropLostSelection();
        Q_EMIT shownCurveChanged(serial);
    });
    connect(&document, &OpenDocument::curvesChanged, this, [this](SheetIndex changed) {
        if (changed != index_)
            return;
        dropStages();
        dropLostSelection();
    });
    connect(&document, &OpenDocument::viewChanged, this, [this](SheetIndex changed) {
        if (changed == index_ && activeSerial() != stagedSerial_)
            dropStages();
    });
    connect(&document, &OpenDocument::replaced, this, [this] {
        dropStages();
        select({});
    });
}

const Curve* ShownSheet::shown(Serial serial) const {
    return stage_ && serial == activeSerial() ? stage_.get() : document_.find(index_, serial);
}

std::shared_ptr<const Curve> ShownSheet::snapshot(Serial serial) const {
    if (stage_ && serial == activeSerial())
        return stage_;
    return document_.find(index_, serial) ? document_.snapshot(index_, serial) : nullptr;
}

Sheet ShownSheet::sheetOnView() const {
    Sheet onView = sheet();
    if (stage_)
        onView.curves[static_cast<std::size_t>(onView.view.activeCurve)] = *stage_;
    return onView;
}

Document ShownSheet::documentOnView() const {
    Document document = document_.value();
    document.sheets[index_] = sheetOnView();
    return document;
}

void ShownSheet::setStage(std::optional<Curve> stage) {
    if (stage ? stage_ && *stage == *stage_ : !stage_)
        return;
    stage_ = stage ? std::make_shared<const Curve>(std::move(*stage)) : nullptr;
    stagedSerial_ = activeSerial();
    Q_EMIT shownCurveChanged(activeSerial());
}

void ShownSheet::setLayerStage(std::optional<int> stage) {
    if (stage == layerStage_)
        return;
    layerStage_ = stage;
    stagedSerial_ = activeSerial();
    Q_EMIT shownCurveChanged(activeSerial());
}

void ShownSheet::dropStages() {
    stage_.reset();
    layerStage_.reset();
}

void ShownSheet::pointOut(Points places) {
    pointedOut_ = std::move(places);
    Q_EMIT pointedOutChanged(true);
}

void ShownSheet::movePointedOut(Points places) {
    if (places == pointedOut_)
        return;
    pointedOut_ = std::move(places);
    Q_EMIT pointedOutChanged(false);
}

void ShownSheet::select(Selection selection) {
    if (selection == selection_)
        return;
    selection_ = std::move(selection);
    Q_EMIT selectionChanged();
}

Selection ShownSheet::allPoints() const {
    Selection all;
    if (const Curve* curve = activeCurve())
        all.insertPoints(activeSerial(), 0, static_cast<int>(pointCount(*curve)));
    return all;
}

void ShownSheet::selectAll() {
    select(allPoints());
}

void ShownSheet::selectNone() {
    select({});
}

void ShownSheet::invertSelection() {
    select(without(allPoints(), selection_));
}

bool ShownSheet::hasSelectedPoints() const {
    const std::span<const GripRef> ofActive = selection_.ofCurve(activeSerial());
    return !ofActive.empty() && ofActive.front().id.kind == GripKind::point;
}

std::vector<int> ShownSheet::selectedPoints() const {
    std::vector<int> points;
    for (const GripRef& grip : selection_.ofCurve(activeSerial())) {
        if (grip.id.kind != GripKind::point)
            break; // points come first
        points.push_back(grip.id.index);
    }
    return points;
}

std::vector<GripId> ShownSheet::selectedGrips(Serial serial) const {
    const std::span<const GripRef> grips = selection_.ofCurve(serial);
    std::vector<GripId> ids(grips.size());
    std::ranges::transform(grips, ids.begin(), &GripRef::id);
    return ids;
}

void ShownSheet::dropLostSelection() {
    Serial serial = 0;
    int count = 0;
    const auto isLost = [&](const GripRef& grip) {
        if (grip.serial != serial) { // those of a curve come together
            serial = grip.serial;
            const Curve* curve = document_.find(index_, serial);
            count = curve ? static_cast<int>(pointCount(*curve)) : 0;
        }
        return grip.id.index >= count;
    };
    Selection lost;
    for (const GripRef& grip : selection_)
        if (isLost(grip))
            lost.insert(grip);
    if (!lost.empty())
        select(without(selection_, lost));
}

void ShownSheet::selectMapped(const Selection& selected, Serial serial, const IndexMap& map) {
    std::vector<GripRef> mapped;
    for (GripRef grip : selected) {
        if (grip.serial == serial)
            grip.id.index = map(grip.id.index);
        if (grip.id.index != IndexMap::kGone)
            mapped.push_back(grip);
    }
    select(Selection(std::move(mapped)));
}

} // namespace kriva::ui
