#include "ui/editing/pointing.h"

#include "core/document/document_drags.h"
#include "ui/editing/hints/hint_text.h"

namespace kriva::ui {
namespace {

[[nodiscard]] bool closesCurve(const SheetEditor& editor, const Hit& under) {
    const bool isOfActive = under.grip && under.grip->serial == editor.activeSerial();
    return isOfActive && under.grip->id == GripId{GripKind::point, 0} && closedAt(*editor.activeCurve(), 0);
}

} // namespace

std::optional<Point> ghostFor(const SheetEditor& editor, const Pointing& now) {
    const bool isAdding = now.tool == Tool::add && !now.modifiers.testFlag(Qt::AltModifier);
    const bool isInserting = isAdding || now.modifiers == (Qt::ControlModifier | Qt::AltModifier);
    const Curve* curve = now.under.curve ? editor.document().find(editor.index(), *now.under.curve) : nullptr;
    if (!curve || !isInserting)
        return {};
    const std::optional<Edited<Curve>> inserted = withPointInserted(*curve, now.at);
    return inserted ? std::optional(pointAt(inserted->curve, newPointNear(*inserted, now.at))) : std::nullopt;
}

QString hintFor(const SheetEditor& editor, const Pointing& now, bool canExplain) {
    const Curve* active = editor.activeCurve();
    const bool pullsHandles = active ? hasHandles(*active) : hasHandles(emptyCurve(editor.index()));
    return hintText({.under = now.under,
                     .modifiers = now.modifiers,
                     .tool = now.tool,
                     .pullsHandles = pullsHandles,
                     .closes = now.tool == Tool::add && closesCurve(editor, now.under),
                     .explains = canExplain && now.tool == Tool::edit && now.modifiers == Qt::NoModifier});
}

} // namespace kriva::ui
