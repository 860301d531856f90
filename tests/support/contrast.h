#pragma once

#include <QColor>

#include <algorithm>
#include <cmath>

namespace kriva::test {

/// The contrast of two colours, 1 to 21: WCAG 2.1, "contrast ratio".
inline double contrast(const QColor& a, const QColor& b) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const auto luminance = [&](const QColor& c) {
        return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
    };
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

} // namespace kriva::test
