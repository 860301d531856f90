#include "core/figure/role_style.h"

#include "core/figure/style/color.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace kriva {
namespace {

/// The same ink on white and on dark paper.
struct Ink {
    Color light;
    Color dark;
};

// The palette of Okabe and Ito, "Color Universal Design" (2008): its hues stay apart for colour-blind readers.
constexpr Color kOrange{0xe6, 0x9f, 0x00};
constexpr Color kSkyBlue{0x56, 0xb4, 0xe9};
constexpr Color kGreen{0x00, 0x9e, 0x73};
constexpr Color kYellow{0xf0, 0xe4, 0x42};
constexpr Color kBlue{0x00, 0x72, 0xb2};
constexpr Color kVermillion{0xd5, 0x5e, 0x00};
constexpr Color kPurple{0xcc, 0x79, 0xa7};

constexpr Ink kPaper{{0xff, 0xff, 0xff}, {0x1e, 0x20, 0x24}};
constexpr Ink kText{{0x26, 0x26, 0x26}, {0xe4, 0xe6, 0xea}};
constexpr Ink kGrey{{0x8c, 0x8c, 0x8c}, {0x8d, 0x92, 0x9a}};
constexpr Ink kDarkGrey{{0x59, 0x59, 0x59}, {0xb4, 0xb8, 0xbf}};
constexpr Ink kCurveInk{kBlue, kSkyBlue}; // blue is too dark for dark paper

// Neighbours in a cycle differ in lightness too, so that a grey print keeps them apart. Yellow shows on dark paper
// only.
constexpr std::array<Ink, 4> kRunInks{{{kBlue, kSkyBlue}, {kOrange, kGreen}, {kGreen, kYellow}, {kSkyBlue, kBlue}}};
constexpr std::array<Ink, 4> kLevelInks{
    {{kGreen, kGreen}, {kOrange, kOrange}, {kPurple, kPurple}, {kSkyBlue, kSkyBlue}}};

constexpr Ink kFaint{{0xde, 0xde, 0xde}, {0x3a, 0x3e, 0x45}};
// Six lines of a plot, then the same inks again with other dashes.
constexpr std::array<Ink, 6> kPlotInks{{{kBlue, kSkyBlue},
                                        {kVermillion, kVermillion},
                                        {kGreen, kGreen},
                                        {kPurple, kPurple},
                                        {kOrange, kOrange},
                                        {kSkyBlue, kYellow}}};
constexpr std::array<Ink, 4> kRuleInks{{{kOrange, kOrange}, {kGreen, kGreen}, {kPurple, kPurple}, {kSkyBlue, kYellow}}};

constexpr std::array<double, 2> kDashes{3, 1.5};
constexpr std::array<double, 2> kDots{1.2, 1.4};
constexpr std::array<double, 4> kDashDot{4.5, 1.5, 1.1, 1.5};
constexpr std::array<double, 2> kLongDashes{7, 1.8};

// Three patterns of lines against four inks: twelve levels before one repeats.
constexpr std::array<std::span<const double>, 3> kLevelDashes{std::span<const double>(), kDashes, kDots};

constexpr std::array<std::span<const double>, 4> kRuleDashes{kDashes, kDots, kDashDot, kLongDashes};

/// What the roles are made of, on one paper.
class Palette {
  public:
    explicit Palette(Theme theme)
        : theme_(theme) {}

    [[nodiscard]] Color operator()(Ink ink) const { return theme_ == Theme::light ? ink.light : ink.dark; }
    [[nodiscard]] Color operator()(Color color) const { return color; }

    template <class AnyInk>
    [[nodiscard]] RoleStyle line(AnyInk ink, double width, std::span<const double> dashes = {}) const {
        return {(*this)(ink), width, std::vector(dashes.begin(), dashes.end()), Marker::none, 0, 0, {}};
    }
    [[nodiscard]] RoleStyle filled(const RoleStyle& line, Marker marker, double size) const {
        // A rim in the paper's colour would eat small marks: they are filled to the edge.
        return {line.color, line.width, line.dashes, marker, size, 0, line.color};
    }
    [[nodiscard]] RoleStyle hollow(const RoleStyle& line, Marker marker, double size, double outline) const {
        return {line.color, line.width, line.dashes, marker, size, outline, (*this)(kPaper)};
    }

  private:
    Theme theme_;
};

std::span<const double> dashesOf(LineDash dash) {
    switch (dash) {
    case LineDash::solid:
        break;
    case LineDash::dashed:
        return kDashes;
    case LineDash::dotted:
        return kDots;
    case LineDash::dashDot:
        return kDashDot;
    }
    return {};
}

/// The pattern of a line so wide: beyond the widest line of any role it grows, or its gaps would close.
std::vector<double> dashesOf(LineDash dash, double width) {
    constexpr double kWidest = 2;
    std::vector<double> lengths;
    for (const double length : dashesOf(dash))
        lengths.push_back(length * std::max(1.0, width / kWidest));
    return lengths;
}

/// The colour at that part of the way from one to another.
Color between(Color from, Color to, double part) {
    const auto mix = [part](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + part * (b - a)));
    };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

template <class Element, std::size_t size>
const Element& cyclic(const std::array<Element, size>& elements, int index) {
    assert(index >= 0);
    return elements[static_cast<std::size_t>(index) % size];
}

} // namespace

RoleStyle styleOf(Role role, int series, Theme theme) {
    const Palette on(theme);
    switch (role) {
    case Role::curve:
        return on.line(kCurveInk, 1.4);
    case Role::controlPolygon:
        return on.line(kGrey, 0.7);
    case Role::derivedPolygon:
        return on.filled(on.line(kVermillion, 0.7, kDashes), Marker::circle, 2.6);
    case Role::construction:
        return on.filled(on.line(cyclic(kLevelInks, series), 0.7, cyclic(kLevelDashes, series)), Marker::circle, 3);
    case Role::left:
        return on.filled(on.line(kGreen, 1), Marker::square, 3.2);
    case Role::right:
        return on.filled(on.line(kPurple, 1), Marker::diamond, 4.6);
    case Role::point:
        return on.hollow(on.line(kDarkGrey, 0), Marker::circle, 4.2, 0.8);
    case Role::knot:
        return on.hollow(on.line(kCurveInk, 0), Marker::square, 4.2, 0.9);
    case Role::handle:
        return on.filled(on.line(kGrey, 0.5), Marker::circle, 3.4);
    case Role::join:
        return on.hollow(on.line(kVermillion, 2), Marker::diamond, 4.6, 0.8);
    case Role::run:
        return on.line(cyclic(kRunInks, series), 1.6);
    case Role::curvePoint:
        return on.filled(on.line(kVermillion, 0), Marker::circle, 5);
    case Role::crossing: // a ring shows the curves that cross in it
        return {on(kVermillion), 0, {}, Marker::ring, 7, 1.2, {}};
    case Role::derivative:
        return on.hollow(on.line(kVermillion, 0.9, kDashDot), Marker::circle, 3.2, 0.8);
    case Role::tangent:
        return on.line(kGreen, 0.9);
    case Role::hull:
        return on.line(kPurple, 0.8, kDots);
    case Role::runPolygon:
        return on.line(cyclic(kRunInks, series), 1.1);
    case Role::fit:
        return on.line(cyclic(kRunInks, series), 1.2);
    case Role::comb:
        return on.line(kPurple, series == 0 ? 0.4 : 0.8);
    case Role::inflection:
        return on.hollow(on.line(kGreen, 0), Marker::diamond, 6, 1.1);
    case Role::rule:
        return on.line(cyclic(kRuleInks, series), 1, cyclic(kRuleDashes, series));
    case Role::label:
        return on.line(kText, 0);
    case Role::axis:
        return on.line(kDarkGrey, 0.6);
    case Role::gridLine:
        return on.line(kFaint, 0.4);
    case Role::plotLine:
        return on.line(cyclic(kPlotInks, series), 1.1,
                       cyclic(kLevelDashes, series / static_cast<int>(kPlotInks.size())));
    case Role::reference:
        return on.line(kGrey, 0.9, kDashes);
    case Role::plotMark:
        return on.filled(on.line(kText, 0), Marker::circle, 3.4);
    }
    return {};
}

RoleStyle styleOf(const Stroke& stroke, Theme theme) {
    RoleStyle style = styleOf(stroke.role, stroke.series, theme);
    style.color = stroke.style.color.value_or(style.color);
    style.width = stroke.style.width.value_or(style.width);
    if (stroke.style.dash)
        style.dashes = dashesOf(*stroke.style.dash, style.width);
    return style;
}

RoleStyle styleOf(const Marks& marks, Theme theme) {
    RoleStyle style = styleOf(marks.role, marks.series, theme);
    style.marker = marks.marker.value_or(style.marker);
    return style;
}

namespace {

/// The colour of a role, as much nearer to that of texts as letters need.
Color readable(Role role, Theme theme) {
    constexpr double kReadable = 4.5; // WCAG 2.1, 1.4.3
    constexpr int kSteps = 20;
    const Color own = styleOf(role, 0, theme).color;
    const Color text = styleOf(Role::label, 0, theme).color;
    for (int step = 0; step < kSteps; ++step) {
        const Color mixed = between(own, text, static_cast<double>(step) / kSteps);
        if (contrast(mixed, paperColor(theme)) >= kReadable)
            return mixed;
    }
    return text;
}

} // namespace

Color labelColor(Role role, Theme theme) {
    using ColorsOfRoles = std::array<Color, static_cast<std::size_t>(Role::plotMark) + 1>;
    // Worked out once: a frame asks for every label.
    static const std::array<ColorsOfRoles, 2> kColors = [] {
        std::array<ColorsOfRoles, 2> colors;
        for (const Theme paper : {Theme::light, Theme::dark})
            for (std::size_t i = 0; i < colors[0].size(); ++i)
                colors[static_cast<std::size_t>(paper)][i] = readable(static_cast<Role>(i), paper);
        return colors;
    }();
    return kColors[static_cast<std::size_t>(theme)][static_cast<std::size_t>(role)];
}

Color paperColor(Theme theme) {
    return Palette(theme)(kPaper);
}

} // namespace kriva
