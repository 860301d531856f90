#include "ui/sheets/sheet_editor.h"

#include "ui/sheets/move_label.h"

#include <QCoreApplication>

#include <algorithm>

namespace kriva::ui {

SheetEditor::SheetEditor(OpenDocument& document, SheetIndex sheet, QObject* parent)
    : QObject(parent)
    , document_(document)
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
        stage_.reset();
        dropLostSelection();
    });
    connect(&document, &OpenDocument::viewChanged, this, [this](SheetIndex changed) {
        if (changed == index_ && activeSerial() != stagedSerial_)
            stage_.reset();
    });
    connect(&document, &OpenDocument::replaced, this, [this] {
        stage_.reset();
        select({});
    });
}

const Curve* SheetEditor::shown(Serial serial) const {
    return stage_ && serial == activeSerial() ? &*stage_ : document_.find(index_, serial);
}

Document SheetEditor::documentOnView() const {
    Document document = document_.value();
    if (stage_)
        document.sheets[index_].curves[static_cast<std::size_t>(sheet().view.activeCurve)] = *stage_;
    return document;
}

void SheetEditor::setStage(std::optional<Curve> stage) {
    if (stage == stage_)
        return;
    stage_ = std::move(stage);
    stagedSerial_ = activeSerial();
    Q_EMIT shownCurveChanged(activeSerial());
}

void SheetEditor::select(Selection selection) {
    if (selection == selection_)
        return;
    selection_ = std::move(selection);
    Q_EMIT selectionChanged();
}

Selection SheetEditor::allPoints() const {
    Selection all;
    if (const Curve* curve = activeCurve())
        for (int i = 0; i < static_cast<int>(pointCount(*curve)); ++i)
            all.insert({activeSerial(), {GripKind::point, i}});
    return all;
}

void SheetEditor::selectAll() {
    select(allPoints());
}

void SheetEditor::selectNone() {
    select({});
}

void SheetEditor::invertSelection() {
    Selection inverse = allPoints();
    for (const GripRef& grip : selection_)
        inverse.erase(grip);
    select(std::move(inverse));
}

std::vector<int> SheetEditor::selectedPoints() const {
    std::vector<int> points;
    for (const GripRef& grip : selection_)
        if (grip.serial == activeSerial() && grip.id.kind == GripKind::point)
            points.push_back(grip.id.index);
    return points;
}

std::vector<GripId> SheetEditor::selectedGrips(Serial serial) const {
    std::vector<GripId> ids;
    for (const GripRef& grip : selection_)
        if (grip.serial == serial)
            ids.push_back(grip.id);
    return ids;
}

void SheetEditor::dropLostSelection() {
    Selection kept;
    for (const GripRef& grip : selection_) {
        const Curve* curve = document_.find(index_, grip.serial);
        if (curve && grip.id.index < static_cast<int>(pointCount(*curve)))
            kept.insert(grip);
    }
    select(std::move(kept));
}

void SheetEditor::applyMap(Serial serial, const IndexMap& map) {
    Selection mapped;
    for (GripRef grip : selection_) {
        if (grip.serial == serial)
            grip.id.index = map(grip.id.index);
        if (grip.id.index != IndexMap::kGone)
            mapped.insert(grip);
    }
    select(std::move(mapped));
}

void SheetEditor::addPoint(Point at) {
    addPoints(std::span(&at, 1));
}

void SheetEditor::addPoints(std::span<const Point> points) {
    if (beginAdding(points))
        document_.endGesture();
}

bool SheetEditor::beginAdding(std::span<const Point> points) {
    const StepLabel label = points.size() == 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Add a point")}
                                               : StepLabel{QT_TRANSLATE_NOOP("Step", "Add points")};
    if (activeCurve())
        document_.beginGesture(index_, activeSerial(), label);
    else if (!document_.beginGestureWithNew(index_, 0, emptyCurve(index_), label))
        return false;
    Curve curve = *activeCurve();
    for (const Point at : points)
        curve = withPointAdded(std::move(curve), at).curve;
    const std::size_t count = pointCount(curve);
    document_.preview(std::move(curve));
    if (pointCount(*activeCurve()) != count) {
        document_.cancelGesture();
        return false;
    }
    select({{activeSerial(), {GripKind::point, static_cast<int>(count) - 1}}});
    return true;
}

void SheetEditor::insertPoint(Serial serial, Point near) {
    const Curve* curve = document_.find(index_, serial);
    if (!curve)
        return;
    std::optional<Edited<Curve>> edited = withPointInserted(*curve, near);
    if (!edited) {
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "No point can be inserted here")});
        return;
    }
    const IndexMap map = std::move(edited->map);
    const Selection before = selection_;
    if (document_.change(index_, serial, std::move(edited->curve), {QT_TRANSLATE_NOOP("Step", "Insert a point")})) {
        selection_ = before;
        applyMap(serial, map);
    }
}

void SheetEditor::removePoints(Serial serial, const std::vector<int>& indices, Removal removal) {
    const Curve* curve = document_.find(index_, serial);
    if (!curve || indices.empty())
        return;
    const Curve before = *curve;
    Refitted<Curve> refitted = removal == Removal::refitted ? withPointsRemovedRefitted(before, indices)
                                                            : Refitted<Curve>{withPointsRemoved(before, indices), {}};
    const StepLabel label = indices.size() == 1 ? StepLabel{QT_TRANSLATE_NOOP("Step", "Remove point %1"), indices[0]}
                                                : StepLabel{QT_TRANSLATE_NOOP("Step", "Remove points")};
    const Selection selected = selection_;
    if (document_.change(index_, serial, std::move(refitted.edited.curve), label)) {
        selection_ = selected; // the change has dropped what lay beyond the end; the map knows where it went
        applyMap(serial, refitted.edited.map);
        tellRemoval(before, *document_.find(index_, serial), refitted.deviation);
    }
}

void SheetEditor::tellRemoval(const Curve& before, const Curve& after, std::optional<double> deviation) {
    const std::optional<int> degree = polynomialDegree(after);
    if (deviation)
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "The shape changes by at most %1"), deviation});
    else if (degree && degree != polynomialDegree(before))
        Q_EMIT hint({QT_TRANSLATE_NOOP("Hint", "The degree falls to %1"), degree});
}

void SheetEditor::removeSelected(Removal removal) {
    removePoints(activeSerial(), selectedPoints(), removal);
}

void SheetEditor::removeLastPoint() {
    if (const Curve* curve = activeCurve(); curve && pointCount(*curve) > 0)
        removePoints(activeSerial(), {static_cast<int>(pointCount(*curve)) - 1}, Removal::plain);
}

void SheetEditor::placePoint(int index, Point at) {
    const Curve* curve = activeCurve();
    if (!curve)
        return;
    const GripId id{GripKind::point, index};
    const std::span ids(&id, 1);
    const Point from = pointAt(*curve, index);
    // What is typed arrives bit for bit by way of zero: x - x + to is `to`, x + (to - x) need not be.
    const bool changesX = at.x != from.x;
    const bool changesY = at.y != from.y;
    const Curve atZero = withGripsMoved(*curve, ids, {changesX ? -from.x : 0, changesY ? -from.y : 0});
    change(withGripsMoved(atZero, ids, {changesX ? at.x : 0, changesY ? at.y : 0}), moveLabel(id));
}

void SheetEditor::nudge(Vector by) {
    const Curve* curve = activeCurve();
    const std::vector<GripId> ids = selectedGrips(activeSerial());
    if (curve && !ids.empty())
        changeInBurst(withGripsMoved(*curve, ids, by), {QT_TRANSLATE_NOOP("Step", "Nudge")});
}

void SheetEditor::change(Curve value, const StepLabel& label) {
    document_.change(index_, activeSerial(), std::move(value), label);
}

void SheetEditor::changeInBurst(Curve value, const StepLabel& label) {
    document_.changeInBurst(index_, activeSerial(), std::move(value), label);
}

void SheetEditor::reverse() {
    const Curve* curve = activeCurve();
    if (!curve)
        return;
    Edited<Curve> edited = reversed(*curve);
    const IndexMap map = std::move(edited.map);
    change(std::move(edited.curve), {QT_TRANSLATE_NOOP("Step", "Reverse the curve")});
    applyMap(activeSerial(), map);
}

void SheetEditor::newCurve() {
    document_.add(index_, static_cast<int>(sheet().curves.size()), emptyCurve(index_),
                  {QT_TRANSLATE_NOOP("Step", "New curve")});
}

void SheetEditor::duplicateCurve(Serial serial) {
    if (const Curve* curve = document_.find(index_, serial))
        document_.add(index_, *document_.indexOf(index_, serial) + 1, *curve,
                      {QT_TRANSLATE_NOOP("Step", "Duplicate the curve")});
}

void SheetEditor::deleteCurve(Serial serial) {
    document_.remove(index_, serial, {QT_TRANSLATE_NOOP("Step", "Delete the curve")});
}

void SheetEditor::renameCurve(Serial serial, const QString& name) {
    if (const Curve* curve = document_.find(index_, serial))
        document_.change(index_, serial, renamed(*curve, name.toStdString()),
                         {QT_TRANSLATE_NOOP("Step", "Rename the curve")});
}

void SheetEditor::colorCurve(Serial serial, Color color) {
    const Curve* curve = document_.find(index_, serial);
    if (!curve)
        return;
    CurveStyle style = styleOf(*curve);
    style.color = color;
    document_.change(index_, serial, withStyle(*curve, style), {QT_TRANSLATE_NOOP("Step", "Colour the curve")});
}

void SheetEditor::moveCurve(Serial serial, int index) {
    if (index >= 0 && index < static_cast<int>(sheet().curves.size()))
        document_.reorder(index_, serial, index, {QT_TRANSLATE_NOOP("Step", "Reorder the curves")});
}

void SheetEditor::activateNextCurve() {
    const std::vector<Serial>& serials = document_.serials(index_);
    if (!serials.empty())
        document_.setActiveCurve(index_,
                                 serials[static_cast<std::size_t>(sheet().view.activeCurve + 1) % serials.size()]);
}

void SheetEditor::clear() {
    document_.endGesture();
    if (sheet().curves.empty())
        return;
    QUndoStack& history = document_.history(index_);
    history.beginMacro(stored({QT_TRANSLATE_NOOP("Step", "Clear the canvas")}));
    for (const Serial serial : std::vector<Serial>(document_.serials(index_)))
        deleteCurve(serial);
    history.endMacro();
}

} // namespace kriva::ui
