#include "ui/sheets/shown_sheet.h"

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
    return stage_ && serial == activeSerial() ? &*stage_ : document_.find(index_, serial);
}

Sheet ShownSheet::sheetOnView() const {
    Sheet onView = sheet();
    onView.stage = layerStage_;
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
    if (stage == stage_)
        return;
    stage_ = std::move(stage);
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
        for (int i = 0; i < static_cast<int>(pointCount(*curve)); ++i)
            all.insert({activeSerial(), {GripKind::point, i}});
    return all;
}

void ShownSheet::selectAll() {
    select(allPoints());
}

void ShownSheet::selectNone() {
    select({});
}

void ShownSheet::invertSelection() {
    Selection inverse = allPoints();
    for (const GripRef& grip : selection_)
        inverse.erase(grip);
    select(std::move(inverse));
}

std::vector<int> ShownSheet::selectedPoints() const {
    std::vector<int> points;
    for (const GripRef& grip : selection_)
        if (grip.serial == activeSerial() && grip.id.kind == GripKind::point)
            points.push_back(grip.id.index);
    return points;
}

std::vector<GripId> ShownSheet::selectedGrips(Serial serial) const {
    std::vector<GripId> ids;
    for (const GripRef& grip : selection_)
        if (grip.serial == serial)
            ids.push_back(grip.id);
    return ids;
}

void ShownSheet::dropLostSelection() {
    Selection kept;
    for (const GripRef& grip : selection_) {
        const Curve* curve = document_.find(index_, grip.serial);
        if (curve && grip.id.index < static_cast<int>(pointCount(*curve)))
            kept.insert(grip);
    }
    select(std::move(kept));
}

void ShownSheet::selectMapped(const Selection& selected, Serial serial, const IndexMap& map) {
    Selection mapped;
    for (GripRef grip : selected) {
        if (grip.serial == serial)
            grip.id.index = map(grip.id.index);
        if (grip.id.index != IndexMap::kGone)
            mapped.insert(grip);
    }
    select(std::move(mapped));
}

} // namespace kriva::ui
