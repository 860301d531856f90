#include "core/io/svg/paths/svg_shapes.h"

#include "core/io/svg/paths/path_reader.h"
#include "core/io/svg/paths/subpaths.h"
#include "core/io/svg/paths/svg_scanner.h"
#include "core/io/svg/xml/svg_xml.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kriva {
namespace {

/// The lengths of one element; remembers the first that cannot be read.
class Lengths {
  public:
    Lengths(const pugi::xml_node& element, const SvgViewport& viewport)
        : element_(element)
        , viewport_(viewport) {}

    double x(const char* name) { return read(name, viewport_.width).value_or(0); }
    double y(const char* name) { return read(name, viewport_.height).value_or(0); }
    double radius(const char* name) {
        return read(name, std::hypot(viewport_.width, viewport_.height) / std::sqrt(2.0)).value_or(0);
    }
    /// Nothing where it is missing or says "auto".
    std::optional<double> corner(const char* name, double whole) {
        if (element_.attribute(name).value() == std::string_view("auto"))
            return {};
        return read(name, whole);
    }
    [[nodiscard]] const SvgViewport& viewport() const { return viewport_; }
    [[nodiscard]] const std::optional<AttributeFault>& fault() const { return fault_; }

  private:
    std::optional<double> read(const char* name, double whole) {
        const pugi::xml_attribute attribute = element_.attribute(name);
        if (!attribute)
            return {};
        const std::optional<double> length = readLength(attribute.value(), whole);
        if (!length && !fault_)
            fault_ = AttributeFault{name};
        return length;
    }

    const pugi::xml_node& element_;
    const SvgViewport& viewport_;
    std::optional<AttributeFault> fault_;
};

void addEllipse(Point centre, double rx, double ry, Subpaths& to) {
    if (!(rx > 0 && ry > 0))
        return;
    const Point right = centre + Vector{rx, 0};
    const Point left = centre - Vector{rx, 0};
    to.moveTo(right);
    to.arcTo({rx, ry, 0, false, true}, left);
    to.arcTo({rx, ry, 0, false, true}, right);
    to.close();
}

void addRectangle(Lengths& lengths, Subpaths& to) {
    const double x = lengths.x("x");
    const double y = lengths.y("y");
    const double width = lengths.x("width");
    const double height = lengths.y("height");
    const std::optional<double> ownX = lengths.corner("rx", lengths.viewport().width);
    const std::optional<double> ownY = lengths.corner("ry", lengths.viewport().height);
    if (!(width > 0 && height > 0))
        return;
    const double rx = std::clamp(ownX.value_or(ownY.value_or(0)), 0.0, width / 2);
    const double ry = std::clamp(ownY.value_or(ownX.value_or(0)), 0.0, height / 2);
    const double right = x + width;
    const double bottom = y + height;
    if (rx == 0 || ry == 0) {
        to.moveTo({x, y});
        to.lineTo({right, y});
        to.lineTo({right, bottom});
        to.lineTo({x, bottom});
        return to.close();
    }
    // Two corners may take a whole side.
    const auto side = [&](Point end) {
        if (to.at() != end)
            to.lineTo(end);
    };
    const EllipticalArc corner{rx, ry, 0, false, true};
    to.moveTo({x + rx, y});
    side({right - rx, y});
    to.arcTo(corner, {right, y + ry});
    side({right, bottom - ry});
    to.arcTo(corner, {right - rx, bottom});
    side({x + rx, bottom});
    to.arcTo(corner, {x, bottom - ry});
    side({x, y + ry});
    to.arcTo(corner, {x + rx, y});
    to.close();
}

bool addPolygon(std::string_view text, bool isClosed, Subpaths& to) {
    SvgScanner scanner(text);
    scanner.skipBlanks();
    for (bool isFirst = true; !scanner.isAtEnd(); isFirst = false) {
        const std::optional<double> x = scanner.number();
        const std::optional<double> y = x ? scanner.number() : std::nullopt;
        if (!y)
            return false;
        isFirst ? to.moveTo({*x, *y}) : to.lineTo({*x, *y});
    }
    if (isClosed && to.pieces() > 0)
        to.close();
    return true;
}

} // namespace

std::optional<double> readLength(std::string_view text, double whole) {
    constexpr std::array<std::pair<std::string_view, double>, 8> kUnits{{{"", 1},
                                                                         {"px", 1},
                                                                         {"mm", 96 / 25.4},
                                                                         {"cm", 96 / 2.54},
                                                                         {"in", 96},
                                                                         {"pt", 96 / 72.0},
                                                                         {"pc", 16},
                                                                         {"q", 96 / 101.6}}};
    SvgScanner scanner(text);
    scanner.skipBlanks();
    const std::optional<double> number = scanner.number();
    if (!number)
        return {};
    if (scanner.take('%')) {
        scanner.skipBlanks();
        return scanner.isAtEnd() ? std::optional(*number / 100 * whole) : std::nullopt;
    }
    const std::string_view unit = scanner.letters();
    scanner.skipBlanks();
    const auto* found = std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
    if (found == kUnits.end() || !scanner.isAtEnd())
        return {};
    return *number * found->second;
}

std::variant<std::vector<Path>, AttributeFault> subpathsOf(const pugi::xml_node& element, const SvgViewport& viewport) {
    const std::string_view name = nameOf(element).local;
    Lengths lengths(element, viewport);
    Subpaths subpaths;
    if (name == "path") {
        auto read = readPathData(element.attribute("d").value());
        if (std::holds_alternative<FileError>(read))
            return AttributeFault{"d"};
        return std::get<std::vector<Path>>(std::move(read));
    }
    if (name == "rect") {
        addRectangle(lengths, subpaths);
    } else if (name == "circle") {
        const double radius = lengths.radius("r");
        addEllipse({lengths.x("cx"), lengths.y("cy")}, radius, radius, subpaths);
    } else if (name == "ellipse") {
        addEllipse({lengths.x("cx"), lengths.y("cy")}, lengths.x("rx"), lengths.y("ry"), subpaths);
    } else if (name == "line") {
        subpaths.moveTo({lengths.x("x1"), lengths.y("y1")});
        subpaths.lineTo({lengths.x("x2"), lengths.y("y2")});
    } else if (name == "polyline" || name == "polygon") {
        if (!addPolygon(element.attribute("points").value(), name == "polygon", subpaths))
            return AttributeFault{"points"};
    }
    if (lengths.fault())
        return *lengths.fault();
    return std::move(subpaths).take();
}

std::string_view farthestAttribute(const pugi::xml_node& element, const SvgViewport& viewport) {
    constexpr std::array<const char*, 13> kLengths{"x",  "y", "width", "height", "rx", "ry", "cx",
                                                   "cy", "r", "x1",    "y1",     "x2", "y2"};
    const std::string_view name = nameOf(element).local;
    if (name == "path")
        return "d";
    if (name == "polyline" || name == "polygon")
        return "points";
    const double whole = std::hypot(viewport.width, viewport.height);
    const auto size = [&](const char* length) {
        return std::abs(readLength(element.attribute(length).value(), whole).value_or(0));
    };
    return *std::ranges::max_element(kLengths, {}, size);
}

} // namespace kriva
