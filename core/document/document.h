#pragma once

#include "core/document/curve.h"

#include <array>
#include <string>
#include <vector>

namespace kriva {

struct Sheet {
    std::vector<Curve> curves; ///< all of the sheet's own kind
    SheetView view;
    friend bool operator==(const Sheet&, const Sheet&) = default;
};

struct Document {
    std::string title;
    SheetIndex active = 0;
    std::array<Sheet, kSheetCount> sheets;
    friend bool operator==(const Document&, const Document&) = default;
};

/// The name of a sheet in documents: "elevation".
[[nodiscard]] std::string_view sheetName(SheetIndex sheet);
[[nodiscard]] std::optional<SheetIndex> sheetNamed(std::string_view name);
/// Its name for people.
[[nodiscard]] Caption captionOf(SheetIndex sheet);
[[nodiscard]] std::span<const LayerInfo> layersOf(SheetIndex sheet);

/// The settings of the views of all sheets. The view of any sheet may hold any of them in a document.
[[nodiscard]] std::vector<ViewSetting> viewSettings();

/// The curves of a sheet of this kind.
template <class C>
[[nodiscard]] std::vector<const C*> curvesOf(const Sheet& sheet) {
    std::vector<const C*> curves;
    for (const Curve& curve : sheet.curves)
        curves.push_back(&std::get<C>(curve));
    return curves;
}

/// Whether two documents differ in what is saved and undone: `active` and `view` do not count.
[[nodiscard]] bool sameContent(const Document& a, const Document& b);

/// What the curves of a sheet have with each other; without rows in sheets where nobody asks. May take seconds, and
/// gives nothing where it was stopped. What is beyond the budget is an answer too: Relations::refusal.
[[nodiscard]] std::optional<Relations> relationsOf(std::span<const Curve* const> curves, SheetIndex index,
                                                   WorkBudget& budget);
[[nodiscard]] std::optional<Relations> relationsOf(const Sheet& sheet, SheetIndex index, WorkBudget& budget);
/// The same within limits::kSteps.
[[nodiscard]] Relations relationsOf(const Sheet& sheet, SheetIndex index);

} // namespace kriva
