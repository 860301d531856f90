#pragma once

#include "core/figure/figure.h"

#include <pugixml.hpp>

#include <variant>

namespace kriva {

/// What lengths in per cent are parts of: the viewport, in user units.
struct SvgViewport {
    double width = 0;
    double height = 0;
};

/// What an attribute of an element cannot be: its name.
struct AttributeFault {
    std::string_view attribute;
};

/// A length in user units, 96 of which are an inch: a number with or without a unit, or per cent of `whole`. Nothing
/// where it is none.
[[nodiscard]] std::optional<double> readLength(std::string_view text, double whole);

/// The subpaths of a `path`, `rect`, `circle`, `ellipse`, `line`, `polyline` or `polygon` in its own coordinates, y
/// down, as SVG 1.1 (9) draws them; none for other elements, and for shapes that have no size.
[[nodiscard]] std::variant<std::vector<Path>, AttributeFault> subpathsOf(const pugi::xml_node& element,
                                                                         const SvgViewport& viewport);

/// The attribute of such an element that leads farthest from its origin.
[[nodiscard]] std::string_view farthestAttribute(const pugi::xml_node& element, const SvgViewport& viewport);

} // namespace kriva
