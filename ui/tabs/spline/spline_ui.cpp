#include "ui/tabs/spline/spline_ui.h"

#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "core/sheets/spline/spline.h"
#include "ui/tabs/spline/spline_actions.h"
#include "ui/tabs/spline/spline_properties.h"

#include <QCoreApplication>

#include <array>

namespace kriva::ui {
namespace {

QString joinText(SplineKnot::Join join) {
    return QCoreApplication::translate("Properties", kJoinTexts[static_cast<std::size_t>(join)]);
}

PointColumn joinColumn() {
    return {QT_TRANSLATE_NOOP("PointColumn", "Join"),
            [](const Curve& curve, int knot) {
                return joinText(std::get<SplineCurve>(curve).knots[static_cast<std::size_t>(knot)].join);
            },
            [](const Curve& curve, int knot, const QString& text) -> std::optional<Curve> {
                for (std::size_t i = 0; i < kJoinTexts.size(); ++i) {
                    const auto join = static_cast<SplineKnot::Join>(i);
                    if (text.trimmed().compare(joinText(join), Qt::CaseInsensitive) == 0)
                        return Curve(withJoin(std::get<SplineCurve>(curve), std::span(&knot, 1), join));
                }
                return {};
            },
            [](const Curve&, int) {
                QStringList joins;
                for (std::size_t i = 0; i < kJoinTexts.size(); ++i)
                    joins.append(joinText(static_cast<SplineKnot::Join>(i)));
                return QCoreApplication::translate("PointColumn", "One of these is needed: %1.")
                    .arg(joins.join(QStringLiteral(", ")));
            },
            {QT_TRANSLATE_NOOP("Step", "Set the join")}};
}

SheetNumber degreeNumber() {
    return {QT_TRANSLATE_NOOP("SheetActions", "Raise the degree"),
            QT_TRANSLATE_NOOP("SheetActions", "Lower the degree"),
            {QT_TRANSLATE_NOOP("Step", "Set the degree")},
            [](const Curve& curve) { return std::get<SplineCurve>(curve).degree; },
            [](const Curve&) {
                return SheetNumber::Range{limits::kSplineDegreeLow, limits::kSplineDegreeHigh};
            },
            [](const Curve& curve, int degree) { return Curve(withDegree(std::get<SplineCurve>(curve), degree)); }};
}

} // namespace

SheetUi splineUi() {
    return {.title = QT_TRANSLATE_NOOP("Sheet", "Spline"),
            .makeProperties = [](SheetEditor& editor, QWidget* parent) { return new SplineProperties(editor, parent); },
            .pointColumns = {joinColumn()},
            .number = degreeNumber(),
            .actions = splineActions()};
}

} // namespace kriva::ui
