#include "ui/sheets/combined/combined_ui.h"

#include "core/combined/views/combined_plots.h"
#include "core/combined/views/combined_tables.h"
#include "core/comparison/methods.h"
#include "core/document/limits.h"
#include "ui/sheets/combined/combined_properties.h"

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
                return changed;
            }};
}

std::vector<Table> tablesOfCombined(const Curve& curve) {
    const CombinedCurve& value = std::get<CombinedCurve>(curve);
    std::vector<Table> tables = tablesOf(value);
    if (value.points.size() > 1)
        tables.push_back(compareMethods(value));
    return tables;
}

} // namespace

SheetUi combinedUi() {
    return {QT_TRANSLATE_NOOP("Sheet", "Combined"),
            [](SheetEditor& editor, QWidget* parent) { return new CombinedProperties(editor, parent); },
            {},
            degreeNumber(),
            {},
            [](const Curve& curve) { return plotsOf(std::get<CombinedCurve>(curve)); },
            tablesOfCombined};
}

} // namespace kriva::ui
