#include "ui/editing/sheet/move_label.h"

#include <QCoreApplication>

namespace kriva::ui {

StepLabel moveLabel(const GripId& grip) {
    switch (grip.kind) {
    case GripKind::point:
        return {QT_TRANSLATE_NOOP("Step", "Move point %1"), grip.index};
    case GripKind::inHandle:
    case GripKind::outHandle:
        return {QT_TRANSLATE_NOOP("Step", "Move a handle of knot %1"), grip.index};
    case GripKind::inner:
        return {QT_TRANSLATE_NOOP("Step", "Move an inner point of segment %1"), grip.index};
    case GripKind::middle:
        return {QT_TRANSLATE_NOOP("Step", "Move the middle point of pair %1"), grip.index};
    case GripKind::startDerivative:
        return {QT_TRANSLATE_NOOP("Step", "Change the start derivative")};
    case GripKind::endDerivative:
        return {QT_TRANSLATE_NOOP("Step", "Change the end derivative")};
    }
    return {};
}

StepLabel retractLabel(const GripId& grip) {
    const bool isHandle = grip.kind == GripKind::inHandle || grip.kind == GripKind::outHandle;
    return isHandle ? StepLabel{QT_TRANSLATE_NOOP("Step", "Retract a handle of knot %1"), grip.index} : moveLabel(grip);
}

} // namespace kriva::ui
