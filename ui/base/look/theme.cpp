#include "ui/base/look/theme.h"

#include "ui/base/look/desktop_scheme.h"
#include "ui/base/look/theme_style.h"

#include <QApplication>

#include <array>
#include <utility>

namespace kriva::ui {

namespace {

/// Okabe and Ito's blue, the colour of the curve: what is chosen is blue wherever it is.
constexpr QRgb kAccent = 0x0072b2;

/// The hues of a theme, from the ground up.
struct Hues {
    QRgb window, base, alternateBase, button;
    QRgb text, paleText;
    QRgb light, midlight, mid, dark, shadow;
    QRgb link, visitedLink;
    QRgb toolTip, toolTipText;
    QRgb paleHighlight;
};

constexpr Hues kLight = {.window = 0xf4f5f6,
                         .base = 0xffffff,
                         .alternateBase = 0xf0f3f6,
                         .button = 0xf9fafb,
                         .text = 0x1d2126,
                         .paleText = 0x8d949b,
                         .light = 0xffffff,
                         .midlight = 0xe9ebee,
                         .mid = 0xc3c8cd,
                         .dark = 0x9ba2a9,
                         .shadow = 0x6d747b,
                         .link = kAccent,
                         .visitedLink = 0x7b4f8a,
                         .toolTip = 0xfffdf3,
                         .toolTipText = 0x1d2126,
                         .paleHighlight = 0xb8c4cd};

constexpr Hues kDark = {.window = 0x26292d,
                        .base = 0x1c1f22,
                        .alternateBase = 0x23272b,
                        .button = 0x30353a,
                        .text = 0xe7e9eb,
                        .paleText = 0x7d858d,
                        .light = 0x3c4248,
                        .midlight = 0x383d43,
                        .mid = 0x33383d,
                        .dark = 0x191b1e,
                        .shadow = 0x0e1011,
                        .link = 0x56b4e9,
                        .visitedLink = 0xcc9bd3,
                        .toolTip = 0x363b41,
                        .toolTipText = 0xe7e9eb,
                        .paleHighlight = 0x3d4a54};

[[nodiscard]] QPalette paletteOf(const Hues& hues) {
    QPalette palette;
    const std::array<std::pair<QPalette::ColorRole, QRgb>, 20> colors = {
        {{QPalette::Window, hues.window},       {QPalette::WindowText, hues.text},
         {QPalette::Base, hues.base},           {QPalette::AlternateBase, hues.alternateBase},
         {QPalette::Text, hues.text},           {QPalette::PlaceholderText, hues.paleText},
         {QPalette::Button, hues.button},       {QPalette::ButtonText, hues.text},
         {QPalette::BrightText, 0xffffff},      {QPalette::Light, hues.light},
         {QPalette::Midlight, hues.midlight},   {QPalette::Mid, hues.mid},
         {QPalette::Dark, hues.dark},           {QPalette::Shadow, hues.shadow},
         {QPalette::Highlight, kAccent},        {QPalette::HighlightedText, 0xffffff},
         {QPalette::Link, hues.link},           {QPalette::LinkVisited, hues.visitedLink},
         {QPalette::ToolTipBase, hues.toolTip}, {QPalette::ToolTipText, hues.toolTipText}}};
    for (const auto& [role, color] : colors)
        palette.setColor(role, QColor(color));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, QColor(hues.paleText));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(hues.paleHighlight));
    return palette;
}

} // namespace

QPalette lightPalette() {
    return paletteOf(kLight);
}

QPalette darkPalette() {
    return paletteOf(kDark);
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

ThemeSwitch::ThemeSwitch(ThemeChoice theme, const DesktopScheme& desktop, QObject* parent)
    : QObject(parent)
    , desktop_(desktop)
    , theme_(theme)
    , systemIsDark_(ui::isDark(QApplication::palette()))
    , shownDark_(isDark()) {
    QApplication::setStyle(new ThemeStyle);
    QApplication::setPalette(shownDark_ ? darkPalette() : lightPalette());
    connect(&desktop, &DesktopScheme::changed, this, &ThemeSwitch::apply);
}

bool ThemeSwitch::isDark() const {
    if (theme_ != ThemeChoice::System)
        return theme_ == ThemeChoice::Dark;
    return desktop_.scheme() == Scheme::Unknown ? systemIsDark_ : desktop_.scheme() == Scheme::Dark;
}

void ThemeSwitch::setTheme(ThemeChoice theme) {
    theme_ = theme;
    apply();
}

void ThemeSwitch::apply() {
    if (isDark() == shownDark_)
        return;
    shownDark_ = isDark();
    QApplication::setPalette(shownDark_ ? darkPalette() : lightPalette());
    Q_EMIT changed();
}

} // namespace kriva::ui
