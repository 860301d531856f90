#include "core/figure/labels.h"

#include <charconv>

namespace kriva {

std::vector<Label> indexedLabels(std::string_view letter, std::span<const Point> points, Role role) {
    std::vector<Label> labels;
    labels.reserve(points.size());
    for (const Point p : points)
        labels.push_back({p, Caption::none, std::string(letter), decimal(static_cast<int>(labels.size())), role});
    return labels;
}

std::string decimal(int number) {
    char digits[16];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

} // namespace kriva
