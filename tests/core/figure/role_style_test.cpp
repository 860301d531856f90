#include "core/figure/role_style.h"
#include "core/figure/style/color.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kriva {
namespace {

constexpr Theme kThemes[] = {Theme::light, Theme::dark};

std::vector<Role> allRoles() {
    std::vector<Role> roles;
    for (int role = 0; role <= static_cast<int>(Role::label); ++role)
        roles.push_back(static_cast<Role>(role));
    return roles;
}

bool isHollow(const RoleStyle& style) {
    return style.markerFill != style.color;
}

bool differWithoutColor(const RoleStyle& a, const RoleStyle& b) {
    return a.width != b.width || !std::equal(a.dashes.begin(), a.dashes.end(), b.dashes.begin(), b.dashes.end()) ||
           a.marker != b.marker || a.markerSize != b.markerSize || isHollow(a) != isHollow(b);
}

TEST(RoleStyle, keepsRolesApartWithoutColour) {
    for (const Theme theme : kThemes)
        for (const Role a : allRoles())
            for (const Role b : allRoles())
                EXPECT_TRUE(a == b || differWithoutColor(styleOf(a, 0, theme), styleOf(b, 0, theme)))
                    << static_cast<int>(a) << " " << static_cast<int>(b);
}

TEST(RoleStyle, keepsNeighbouringRunsApartInGreyscale) {
    for (const Theme theme : kThemes)
        for (int run = 0; run < 12; ++run)
            EXPECT_GT(contrast(styleOf(Role::run, run, theme).color, styleOf(Role::run, run + 1, theme).color), 1.35)
                << run;
}

TEST(RoleStyle, givesTwelveLevelsTheirOwnLook) {
    for (int a = 0; a < 12; ++a) {
        for (int b = 0; b < a; ++b) {
            const RoleStyle x = styleOf(Role::construction, a, Theme::light);
            const RoleStyle y = styleOf(Role::construction, b, Theme::light);
            EXPECT_TRUE(x.color != y.color || differWithoutColor(x, y)) << a << " " << b;
            EXPECT_TRUE(a != b + 1 || differWithoutColor(x, y)) << a << " " << b;
        }
    }
}

TEST(RoleStyle, standsOutFromThePaper) {
    for (const Theme theme : kThemes)
        for (const Role role : allRoles())
            for (int series = 0; series < 4; ++series)
                EXPECT_GT(contrast(styleOf(role, series, theme).color, paperColor(theme)), 2) << static_cast<int>(role);
}

TEST(RoleStyle, followsTheStyleOfItsCurve) {
    Stroke stroke;
    stroke.style.color = Color{1, 2, 3};
    stroke.style.width = 4.5;
    EXPECT_EQ(styleOf(stroke, Theme::light).color, (Color{1, 2, 3}));
    EXPECT_EQ(styleOf(stroke, Theme::light).width, 4.5);
}

TEST(RoleStyle, takesTheDashesOfItsCurve) {
    Stroke stroke;
    EXPECT_TRUE(styleOf(stroke, Theme::light).dashes.empty());
    stroke.style.dash = LineDash::dashDot;
    EXPECT_EQ(styleOf(stroke, Theme::light).dashes.size(), 4u);
    stroke.role = Role::derivedPolygon;
    stroke.style.dash = LineDash::solid;
    EXPECT_TRUE(styleOf(stroke, Theme::light).dashes.empty());
}

TEST(RoleStyle, dashesOfAWideLineKeepTheirGaps) {
    Stroke stroke;
    stroke.style.dash = LineDash::dotted;
    const std::vector<double> thin = styleOf(stroke, Theme::light).dashes;
    stroke.style.width = kMostWidth;
    const std::vector<double> wide = styleOf(stroke, Theme::light).dashes;
    ASSERT_EQ(wide.size(), thin.size());
    for (std::size_t i = 0; i < wide.size(); ++i)
        EXPECT_DOUBLE_EQ(wide[i], 10 * thin[i]);
}

TEST(Contrast, isThatOfWcag) {
    EXPECT_DOUBLE_EQ(contrast({0, 0, 0}, {255, 255, 255}), 21);
    EXPECT_DOUBLE_EQ(contrast({255, 255, 255}, {0, 0, 0}), 21);
    EXPECT_NEAR(contrast({0x77, 0x77, 0x77}, {255, 255, 255}), 4.478, 1e-3); // the well-known grey that just fails
    EXPECT_DOUBLE_EQ(contrast({1, 2, 3}, {1, 2, 3}), 1);
}

TEST(RoleStyle, hasReadableLabels) {
    for (const Theme theme : kThemes) {
        for (const Role role : allRoles())
            EXPECT_GE(contrast(labelColor(role, theme), paperColor(theme)), 4.5) << static_cast<int>(role);
        EXPECT_EQ(labelColor(Role::label, theme), styleOf(Role::label, 0, theme).color);
        EXPECT_EQ(labelColor(Role::point, theme), styleOf(Role::point, 0, theme).color) << "it is dark enough";
    }
}

TEST(RoleStyle, takesTheShapeOfMarksFromTheirCurve) {
    Marks marks;
    const RoleStyle usual = styleOf(marks, Theme::light);
    EXPECT_EQ(usual.marker, Marker::circle);
    marks.marker = Marker::diamond;
    const RoleStyle chosen = styleOf(marks, Theme::light);
    EXPECT_EQ(chosen.marker, Marker::diamond);
    EXPECT_EQ(chosen.markerSize, usual.markerSize);
}

} // namespace
} // namespace kriva
