#pragma once

#include "core/figure/style/style.h"

#include <span>
#include <string_view>

namespace kriva {

/// A number, or several, by which the figure of one sheet can be changed for looking at it; its curve lists them.
struct ViewSetting {
    std::string_view name; ///< its key in documents
    double least = 0;
    double most = 1;
    double usual = 0; ///< of a single number
    bool isWhole = false;
    std::size_t mostNumbers = 0; ///< so many at most, each strictly between the two; 0 for a single number
};

/// The number of a view; the usual one without a view.
[[nodiscard]] double numberOf(const SheetView* view, const ViewSetting& setting);
/// The numbers of a view; none without a view.
[[nodiscard]] std::span<const double> numbersOf(const SheetView* view, const ViewSetting& setting);

/// The view with other numbers for a setting: one, or as many as it takes.
[[nodiscard]] SheetView withNumbers(SheetView view, const ViewSetting& setting, std::vector<double> numbers);

} // namespace kriva
