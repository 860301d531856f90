#include "tests/support/contrast.h"
#include "ui/base/look/theme.h"
#include "ui/base/look/theme_style.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyleOption>

namespace kriva::ui {
namespace {

using test::contrast;

constexpr int kSide = 13;

QImage empty(QStyle::PrimitiveElement element, const QPalette& palette) {
    QImage image(kSide, kSide, QImage::Format_RGB32);
    image.fill(palette.color(QPalette::Window));
    QPainter painter(&image);
    QStyleOptionButton option;
    option.rect = image.rect();
    option.palette = palette;
    option.state = QStyle::State_Enabled | QStyle::State_Off;
    ThemeStyle().drawPrimitive(element, &option, &painter, nullptr);
    return image;
}

/// The colour of the frame: of all on the way to the middle, the one that stands out most from the window.
QColor frameOf(const QImage& image, const QColor& window) {
    QColor frame = window;
    for (int y = 0; y < kSide / 2; ++y)
        if (const QColor color = image.pixelColor(kSide / 2, y); contrast(color, window) > contrast(frame, window))
            frame = color;
    return frame;
}

// WCAG 2.1, 1.4.11, asks 3 to 1 of what shows that something is there to be clicked.
TEST(ThemeStyle, emptyBoxesCanBeSeenInTheDark) {
    const QPalette palette = darkPalette();
    for (const auto element :
         {QStyle::PE_IndicatorCheckBox, QStyle::PE_IndicatorRadioButton, QStyle::PE_IndicatorItemViewItemCheck}) {
        const QImage image = empty(element, palette);
        const QColor frame = frameOf(image, palette.color(QPalette::Window));
        EXPECT_GE(contrast(frame, palette.color(QPalette::Window)), 3);
        EXPECT_GE(contrast(frame, image.pixelColor(kSide / 2, kSide / 2)), 3);
    }
}

TEST(ThemeStyle, theIconsOfPanelsFollowTheTheme) {
    const QPalette before = QApplication::palette();
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
        QApplication::setPalette(palette);
        for (const auto which : {QStyle::SP_TitleBarCloseButton, QStyle::SP_TitleBarNormalButton,
                                 QStyle::SP_ToolBarHorizontalExtensionButton}) {
            const QImage image = ThemeStyle().standardIcon(which, nullptr, nullptr).pixmap(32).toImage();
            bool hasInk = false;
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x)
                    hasInk |= image.pixelColor(x, y) == palette.color(QPalette::ButtonText);
            EXPECT_TRUE(hasInk) << which;
        }
    }
    QApplication::setPalette(before);
}

} // namespace
} // namespace kriva::ui
