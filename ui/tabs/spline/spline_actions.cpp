#include "ui/tabs/spline/spline_actions.h"

#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/handle_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"
#include "ui/editing/sheet_editor.h"

#include <QCoreApplication>

#include <algorithm>

namespace kriva::ui {
namespace {

using Group = SheetAction::Group;
using Join = SplineKnot::Join;
using HandleEdit = SplineCurve (*)(const SplineCurve&, std::span<const int>);

const SplineCurve& valueOf(const SheetEditor& editor) {
    return std::get<SplineCurve>(*editor.activeCurve());
}

bool isHandleOfKnot(const GripId& grip) {
    return grip.kind == GripKind::inHandle || grip.kind == GripKind::outHandle;
}

bool isOfKnot(const GripRef& grip) {
    return grip.id.kind == GripKind::point || isHandleOfKnot(grip.id);
}

std::span<const GripRef> selectedGripsOf(const SheetEditor& editor) {
    return editor.selection().ofCurve(editor.activeSerial());
}

bool hasChosenKnots(const SheetEditor& editor) {
    return pullsHandles(valueOf(editor)) && std::ranges::any_of(selectedGripsOf(editor), isOfKnot);
}

SheetAction joinAction(const char* name, const char* text, Qt::Key key, Join join) {
    return {Group::joins,
            name,
            text,
            Qt::SHIFT | key,
            [join](SheetEditor& editor) {
                editor.change(Curve(withJoin(valueOf(editor), chosenKnots(editor), join)),
                              {QT_TRANSLATE_NOOP("Step", "Set the join")});
            },
            hasChosenKnots,
            [join](const SheetEditor& editor) {
                const std::vector<SplineKnot>& knots = valueOf(editor).knots;
                return hasChosenKnots(editor) && std::ranges::all_of(selectedGripsOf(editor), [&](const GripRef& grip) {
                           return !isOfKnot(grip) || knots[static_cast<std::size_t>(grip.id.index)].join == join;
                       });
            }};
}

SheetAction handleAction(const char* name, const char* text, const StepLabel& step, HandleEdit edit) {
    return {
        Group::handles,
        name,
        text,
        {},
        [step, edit](SheetEditor& editor) { editor.change(Curve(edit(valueOf(editor), chosenKnots(editor))), step); },
        hasChosenKnots,
        {}};
}

/// Both handles of selected knots, and of other knots those that are selected.
void retractHandles(SheetEditor& editor) {
    SplineCurve retracted = withHandlesRetracted(valueOf(editor), editor.selectedPoints());
    for (const GripId& grip : editor.selectedGrips(editor.activeSerial()))
        if (isHandleOfKnot(grip))
            retracted = withHandleRetracted(retracted, grip).value_or(retracted);
    editor.change(Curve(std::move(retracted)), {QT_TRANSLATE_NOOP("Step", "Retract the handles")});
}

SheetAction closeAction() {
    return {Group::curve,
            "closed",
            QT_TRANSLATE_NOOP("SheetActions", "Closed"),
            {},
            [](SheetEditor& editor) {
                const bool isClosing = !valueOf(editor).closed;
                editor.change(Curve(withClosed(valueOf(editor), isClosing)),
                              isClosing ? StepLabel{QT_TRANSLATE_NOOP("Step", "Close the curve")}
                                        : StepLabel{QT_TRANSLATE_NOOP("Step", "Open the curve")});
            },
            [](const SheetEditor&) { return true; },
            [](const SheetEditor& editor) { return valueOf(editor).closed; }};
}

} // namespace

std::vector<int> chosenKnots(const SheetEditor& editor) {
    std::vector<int> knots;
    for (const GripRef& grip : selectedGripsOf(editor))
        if (isOfKnot(grip))
            knots.push_back(grip.id.index);
    if (!std::ranges::is_sorted(knots)) // as it is where no handles are among them
        std::ranges::sort(knots);
    const auto repeated = std::ranges::unique(knots);
    knots.erase(repeated.begin(), repeated.end());
    return knots;
}

std::vector<SheetAction> splineActions() {
    return {
        joinAction("corner", QT_TRANSLATE_NOOP("SheetActions", "Corner"), Qt::Key_C, Join::corner),
        joinAction("smooth", QT_TRANSLATE_NOOP("SheetActions", "Smooth"), Qt::Key_S, Join::smooth),
        joinAction("symmetric", QT_TRANSLATE_NOOP("SheetActions", "Symmetric"), Qt::Key_Y, Join::symmetric),
        joinAction("automatic", QT_TRANSLATE_NOOP("SheetActions", "Automatic"), Qt::Key_A, Join::automatic),
        handleAction("alignHandles", QT_TRANSLATE_NOOP("SheetActions", "Align handles"),
                     {QT_TRANSLATE_NOOP("Step", "Align the handles")}, withHandlesAligned),
        handleAction("equalizeHandles", QT_TRANSLATE_NOOP("SheetActions", "Equalize handles"),
                     {QT_TRANSLATE_NOOP("Step", "Equalize the handles")}, withHandlesEqualized),
        handleAction("pullOutHandles", QT_TRANSLATE_NOOP("SheetActions", "Pull out handles"),
                     {QT_TRANSLATE_NOOP("Step", "Pull out the handles")}, withHandlesPulledOut),
        {Group::handles,
         "retractHandles",
         QT_TRANSLATE_NOOP("SheetActions", "Retract handles"),
         {},
         retractHandles,
         hasChosenKnots,
         {}},
        closeAction(),
    };
}

} // namespace kriva::ui
