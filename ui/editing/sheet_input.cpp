#include "ui/editing/sheet_input.h"

#include "core/document/document_drags.h"
#include "ui/editing/hints/hint_text.h"

#include <algorithm>

namespace kriva::ui {
namespace {

/// Where a point would come if it were inserted now; nothing where a click would insert none.
[[nodiscard]] std::optional<Point> ghostFor(const SheetEditor& editor, const PointerEvent& now, Tool tool) {
    const bool isAdding = tool == Tool::add && !now.with(Qt::AltModifier);
    const bool isInserting = isAdding || now.modifiers == (Qt::ControlModifier | Qt::AltModifier);
    const Curve* curve = now.under.curve ? editor.document().find(editor.index(), *now.under.curve) : nullptr;
    if (!curve || !isInserting)
        return {};
    const std::optional<Edited<Curve>> inserted = withPointInserted(*curve, now.at);
    return inserted ? std::optional(pointAt(inserted->curve, newPointNear(*inserted, now.at))) : std::nullopt;
}

[[nodiscard]] QString hintFor(const SheetEditor& editor, const PointerEvent& now, Tool tool, bool canExplain) {
    const Curve* active = editor.activeCurve();
    const bool pullsHandles = active ? hasHandles(*active) : hasHandles(emptyCurve(editor.index()));
    return hintText({.under = now.under,
                     .modifiers = now.modifiers,
                     .tool = tool,
                     .pullsHandles = pullsHandles,
                     .closes = tool == Tool::add && now.under.grip && editor.closedAt(*now.under.grip),
                     .explains = canExplain && tool == Tool::edit && now.modifiers == Qt::NoModifier});
}

} // namespace

SheetInput::SheetInput(SheetEditor& editor, std::span<const Role> explained)
    : editor_(editor)
    , explained_(explained)
    , canvas_(new CanvasView(*this)) {
    connect(&editor, &SheetEditor::drawingBegun, this, [this] { canvas_->setTool(Tool::add); });
}

Point SheetInput::snapped(Point at) const {
    const std::optional<Snap> snap = isSnapping_ ? canvas_->scene().snapOf({.at = at}) : std::nullopt;
    return snap ? snap->at : at;
}

bool SheetInput::canExplain(const std::optional<MarkPlace>& mark) const {
    return mark && std::ranges::find(explained_, mark->role) != explained_.end();
}

void SheetInput::hover(const PointerEvent& now) {
    CanvasScene& scene = canvas_->scene();
    const Tool tool = canvas_->tool();
    const bool wouldAdd = isSnapping_ && tool == Tool::add && !now.under.curve;
    scene.setSnap(wouldAdd ? scene.snapOf({.at = now.at}) : std::nullopt);
    scene.setGhost(ghostFor(editor_, now, tool));
    Q_EMIT hintChanged(hintFor(editor_, now, tool, canExplain(now.under.mark)));
}

void SheetInput::click(const PointerEvent& press) {
    if (press.button == Qt::RightButton)
        requestMenu(press);
    else if (press.with(Qt::AltModifier))
        clickWithAlt(press);
    else if (canvas_->tool() == Tool::add)
        clickWithAddTool(press);
    else
        clickWithEditTool(press);
}

void SheetInput::requestMenu(const PointerEvent& press) {
    const QPoint pixel = press.pixel.toPoint();
    menuPlace_.reset();
    if (const auto& grip = press.under.grip) {
        if (!editor_.selection().contains(*grip))
            select({*grip});
        editor_.activate(grip->serial);
    } else if (press.under.curve) {
        editor_.activate(*press.under.curve);
        menuPlace_ = CurvePlace{*press.under.curve, canvas_->mapping().toDocument(pixel)};
    }
    const QPoint place = canvas_->viewport()->mapToGlobal(pixel);
    Q_EMIT menuRequested(place, press.under);
}

void SheetInput::clickWithAlt(const PointerEvent& press) {
    const auto& [grip, curve, mark] = press.under;
    if (press.with(Qt::ControlModifier)) {
        if (curve)
            editor_.insertPoint(*curve, press.at);
    } else if (!grip) {
        editor_.addPoint(snapped(press.at));
    } else if (grip->id.kind == GripKind::point) {
        editor_.removePoints(grip->serial, {grip->id.index}, Removal::refitted);
    }
}

void SheetInput::clickWithAddTool(const PointerEvent& press) {
    if (!press.under.grip)
        addPoint(press);
    else if (editor_.closeAt(*press.under.grip))
        canvas_->setTool(Tool::edit);
    else
        editor_.addPoint(snapped(press.at));
}

void SheetInput::clickWithEditTool(const PointerEvent& press) {
    const auto& [grip, curve, mark] = press.under;
    const bool isToggling = press.with(Qt::ShiftModifier);
    if (grip && press.with(Qt::ControlModifier) && isHandle(grip->id.kind)) {
        editor_.retractHandle(*grip);
    } else if (grip) {
        const Selection clicked{*grip};
        const Selection& before = editor_.selection();
        if (!isToggling)
            select(clicked);
        else
            select(before.contains(*grip) ? without(before, clicked) : united(before, clicked));
    } else {
        if (curve)
            editor_.activate(*curve);
        else if (!isToggling)
            editor_.selectNone();
        if (canExplain(mark))
            Q_EMIT explanationRequested(*mark);
    }
}

bool SheetInput::doubleClick(const PointerEvent& press) {
    const bool isPlain = press.button == Qt::LeftButton && press.modifiers == Qt::NoModifier;
    if (!isPlain || canvas_->tool() == Tool::add || press.under.grip)
        return false;
    addPoint(press);
    return true;
}

void SheetInput::addPoint(const PointerEvent& press) {
    if (press.under.curve)
        editor_.insertPoint(*press.under.curve, press.at);
    else
        editor_.addPoint(snapped(press.at));
}

bool SheetInput::beginDrag(const PointerEvent& press) {
    const auto& [grip, curve, mark] = press.under;
    const bool isAlt = press.with(Qt::AltModifier);
    const bool isAdding = canvas_->tool() == Tool::add;
    if (grip && !isAlt) {
        if (!editor_.selection().contains(*grip))
            select(press.with(Qt::ShiftModifier) ? united(editor_.selection(), {*grip}) : Selection{*grip});
        drag_.begin(*grip);
        return true;
    }
    if (isAlt || press.with(Qt::ShiftModifier) || (!curve && !isAdding))
        return false;
    if (!curve)
        drag_.beginAdding(snapped(press.at));
    else if (isAdding)
        drag_.beginInserting(*curve, press.at);
    else
        drag_.beginOnCurve(*curve, press.at);
    return true;
}

void SheetInput::drag(Vector by, const DragKeys& keys) {
    CanvasScene& scene = canvas_->scene();
    const std::optional<SnappingPlace> place = isSnapping_ ? drag_.snappingPlace(by, keys) : std::nullopt;
    const std::optional<Snap> snap = place ? scene.snapOf(*place) : std::nullopt;
    scene.setSnap(snap);
    drag_.move(by, keys, snap ? std::optional(snap->at) : std::nullopt);
    if (drag_.handle())
        Q_EMIT hintChanged(dragHintText(keys));
}

void SheetInput::endDrag() {
    canvas_->scene().setSnap({});
    drag_.end();
}

void SheetInput::cancelDrag() {
    canvas_->scene().setSnap({});
    drag_.cancel();
}

void SheetInput::select(Selection selection) {
    // Panels show the active curve: choosing points of another curve alone makes that one active.
    const bool isOfOneCurve = !selection.empty() && selection.front().serial == selection.back().serial;
    if (isOfOneCurve)
        editor_.activate(selection.front().serial);
    editor_.select(std::move(selection));
}

void SheetInput::insertPoint(std::optional<CurvePlace> place) {
    if (place)
        editor_.insertPoint(place->curve, place->near);
    else
        editor_.insertPointBehindSelected();
}

} // namespace kriva::ui
