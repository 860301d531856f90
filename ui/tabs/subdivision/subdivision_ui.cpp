#include "ui/tabs/subdivision/subdivision_ui.h"

#include "core/sheets/subdivision/subdivision.h"
#include "ui/base/language/number_text.h"
#include "ui/tabs/subdivision/subdivision_actions.h"
#include "ui/tabs/subdivision/subdivision_properties.h"

#include <algorithm>

namespace kriva::ui {
namespace {

NumberRange multiplicities(const SubdivisionCurve& curve, int point) {
    return {1, static_cast<double>(mostMultiplicity(curve, std::span(&point, 1))), false, true};
}

PointColumn multiplicityColumn() {
    return {
        QT_TRANSLATE_NOOP("PointColumn", "Multiplicity"),
        [](const Curve& curve, int point) {
            const auto& value = std::get<SubdivisionCurve>(curve);
            return QString::number(value.multiplicity[static_cast<std::size_t>(point)]);
        },
        [](const Curve& curve, int point, const QString& text) -> std::optional<Curve> {
            const auto& value = std::get<SubdivisionCurve>(curve);
            const std::optional<double> times = parseNumber(text);
            if (!times || !multiplicities(value, point).contains(*times))
                return {};
            return Curve(withMultiplicity(value, point, static_cast<int>(*times)));
        },
        [](const Curve& curve, int point) { return multiplicities(std::get<SubdivisionCurve>(curve), point).text(); },
        {QT_TRANSLATE_NOOP("Step", "Set the multiplicity")}};
}

SheetNumber levelsNumber() {
    return {
        QT_TRANSLATE_NOOP("SheetActions", "One level more"),
        QT_TRANSLATE_NOOP("SheetActions", "One level fewer"),
        {QT_TRANSLATE_NOOP("Step", "Set the levels")},
        [](const Curve& curve) { return std::get<SubdivisionCurve>(curve).levels; },
        [](const Curve& curve) {
            const std::size_t count = controlPointCount(std::get<SubdivisionCurve>(curve));
            return SheetNumber::Range{0, mostLevels(std::max<std::size_t>(count, 2))};
        },
        [](const Curve& curve, int levels) { return Curve(withLevels(std::get<SubdivisionCurve>(curve), levels)); }};
}

} // namespace

SheetUi subdivisionUi() {
    return {.title = QT_TRANSLATE_NOOP("Sheet", "Subdivision"),
            .makeProperties = [](SheetEditor& editor,
                                 QWidget* parent) { return new SubdivisionProperties(editor, parent); },
            .pointColumns = {multiplicityColumn()},
            .number = levelsNumber(),
            .actions = subdivisionActions(),
            .explained = {Role::construction, Role::left, Role::right, Role::curvePoint}};
}

} // namespace kriva::ui
