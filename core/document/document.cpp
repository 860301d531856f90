#include "core/document/document.h"

#include "core/curve/limits.h"

#include <algorithm>
#include <iterator>

namespace kriva {
namespace {

bool sameContent(const Curve& a, const Curve& b) {
    return viewOf(a) == viewOf(b) ? a == b : withView(a, viewOf(b)) == b;
}

} // namespace

std::string_view sheetName(SheetIndex sheet) {
    return std::visit([](const auto& curve) { return curve.kSheet; }, emptyCurve(sheet));
}

std::optional<SheetIndex> sheetNamed(std::string_view name) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        if (sheetName(sheet) == name)
            return sheet;
    return {};
}

Caption captionOf(SheetIndex sheet) {
    return std::visit([](const auto& curve) { return curve.kCaption; }, emptyCurve(sheet));
}

std::span<const LayerInfo> layersOf(SheetIndex sheet) {
    return std::visit([](const auto& c) { return layersOf(c); }, emptyCurve(sheet));
}

std::vector<ViewSetting> viewSettings() {
    std::vector<ViewSetting> all;
    const auto add = [&]<class C>(const C& curve) {
        if constexpr (C::kCapabilities.viewSettings)
            std::ranges::copy(viewSettingsOf(curve), std::back_inserter(all));
    };
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
        std::visit(add, emptyCurve(sheet));
    return all;
}

bool sameContent(const Document& a, const Document& b) {
    const auto sameCurves = [](const Sheet& x, const Sheet& y) {
        return std::equal(x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
                          [](const Curve& c, const Curve& d) { return sameContent(c, d); });
    };
    return a.title == b.title && std::equal(a.sheets.begin(), a.sheets.end(), b.sheets.begin(), sameCurves);
}

std::optional<Relations> relationsOf(std::span<const Curve* const> curves, SheetIndex index, WorkBudget& budget) {
    return std::visit(
        [&]<class C>(const C&) -> std::optional<Relations> {
            if constexpr (C::kCapabilities.relations) {
                std::vector<const C*> ofKind(curves.size());
                std::ranges::transform(curves, ofKind.begin(), [](const Curve* curve) { return &std::get<C>(*curve); });
                return relationsOf(std::span<const C* const>(ofKind), budget);
            } else {
                return Relations();
            }
        },
        emptyCurve(index));
}

std::optional<Relations> relationsOf(const Sheet& sheet, SheetIndex index, WorkBudget& budget) {
    std::vector<const Curve*> curves(sheet.curves.size());
    std::ranges::transform(sheet.curves, curves.begin(), [](const Curve& curve) { return &curve; });
    return relationsOf(curves, index, budget);
}

Relations relationsOf(const Sheet& sheet, SheetIndex index) {
    WorkBudget budget(limits::kSteps);
    return *relationsOf(sheet, index, budget); // nobody stops it
}

} // namespace kriva
