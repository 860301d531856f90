#include "ui/tabs/combined/combined_ui.h"

#include "core/document/methods.h"
#include "core/sheets/combined/combined.h"
#include "ui/tabs/combined/combined_properties.h"

namespace kriva::ui {
namespace {

SheetNumber degreeNumber() {
    return {QT_TRANSLATE_NOOP("SheetActions", "Raise the degree"),
            QT_TRANSLATE_NOOP("SheetActions", "Lower the degree"),
            {QT_TRANSLATE_NOOP("Step", "Set the degree")},
            [](const Curve& curve) { return std::get<CombinedCurve>(curve).degree; },
            [](const Curve& curve) {
                const CombinedCurve& value = std::get<CombinedCurve>(curve);
                const bool isFixed = value.method == CombinedCurve::Method::interpolation;
                return isFixed ? SheetNumber::Range{value.degree, value.degree}
                               : SheetNumber::Range{limits::kFitDegreeLow, limits::kFitDegreeHigh};
            },
            [](const Curve& curve, int degree) {
                CombinedCurve changed = std::get<CombinedCurve>(curve);
                changed.degree = degree;
                return Curve(std::move(changed));
            }};
}

std::optional<std::vector<Table>> tablesOfCombined(const Curve& curve, WorkBudget& budget) {
    const CombinedCurve& value = std::get<CombinedCurve>(curve);
    std::optional<std::vector<Table>> tables = tablesOf(value, budget);
    if (!tables || value.points.size() < 2)
        return tables;
    std::optional<Table> methods = compareMethods(value, budget);
    if (!methods)
        return {};
    tables->push_back(*std::move(methods));
    return tables;
}

} // namespace

SheetUi combinedUi() {
    return {
        .title = QT_TRANSLATE_NOOP("Sheet", "Combined"),
        .makeProperties = [](SheetEditor& editor, QWidget* parent) { return new CombinedProperties(editor, parent); },
        .number = degreeNumber(),
        .tables = tablesOfCombined};
}

} // namespace kriva::ui
