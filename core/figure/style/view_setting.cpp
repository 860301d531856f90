#include "core/figure/style/view_setting.h"

#include <utility>

namespace kriva {

double numberOf(const SheetView* view, const ViewSetting& setting) {
    const std::span<const double> numbers = numbersOf(view, setting);
    return numbers.empty() ? setting.usual : numbers.front();
}

std::span<const double> numbersOf(const SheetView* view, const ViewSetting& setting) {
    if (!view)
        return {};
    const auto found = view->settings.find(setting.name);
    return found == view->settings.end() ? std::span<const double>() : std::span(found->second);
}

SheetView withNumbers(SheetView view, const ViewSetting& setting, std::vector<double> numbers) {
    const bool isUsual = setting.mostNumbers == 0 ? numbers == std::vector{setting.usual} : numbers.empty();
    if (isUsual)
        view.settings.erase(std::string(setting.name));
    else
        view.settings.insert_or_assign(std::string(setting.name), std::move(numbers));
    return view;
}

} // namespace kriva
