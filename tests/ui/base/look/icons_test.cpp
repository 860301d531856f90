#include "ui/base/look/icons.h"

#include <gtest/gtest.h>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPalette>

#include <set>

namespace kriva::ui {
namespace {

constexpr auto kIconCount = static_cast<int>(IconName::More) + 1;

QImage imageOf(const QIcon& icon, int side, qreal ratio = 1, QIcon::Mode mode = QIcon::Normal) {
    return icon.pixmap(QSize(side, side), ratio, mode).toImage().convertToFormat(QImage::Format_ARGB32);
}

/// How many pixels are painted fully.
int inkOf(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y).alpha() == 255 ? 1 : 0;
    }
    return count;
}

/// The colours of what is painted fully.
std::set<QRgb> colorsOf(const QImage& image) {
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y).alpha() == 255)
                colors.insert(image.pixel(x, y));
        }
    }
    return colors;
}

QPalette paletteOf(const QColor& text, const QColor& disabled, const QColor& selected) {
    QPalette palette;
    palette.setColor(QPalette::ButtonText, text);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, disabled);
    palette.setColor(QPalette::HighlightedText, selected);
    return palette;
}

TEST(Icons, everyNameHasADrawingOfItsOwn) {
    std::set<QByteArray> drawings;
    for (int name = 0; name < kIconCount; ++name) {
        const QImage image = imageOf(icon(static_cast<IconName>(name)), 48);
        EXPECT_GT(inkOf(image), 40) << "icon " << name;
        drawings.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes()));
    }
    EXPECT_EQ(static_cast<int>(drawings.size()), kIconCount);
}

TEST(Icons, theInkHasTheColourOfThePaletteInEveryMode) {
    const QPalette palette = paletteOf(Qt::red, Qt::green, Qt::blue);
    for (int name = 0; name < kIconCount; ++name) {
        const QIcon tinted = icon(static_cast<IconName>(name), palette);
        EXPECT_EQ(colorsOf(imageOf(tinted, 48)), std::set{QColor(Qt::red).rgba()});
        EXPECT_EQ(colorsOf(imageOf(tinted, 48, 1, QIcon::Disabled)), std::set{QColor(Qt::green).rgba()});
        EXPECT_EQ(colorsOf(imageOf(tinted, 48, 1, QIcon::Selected)), std::set{QColor(Qt::blue).rgba()});
    }
}

TEST(Icons, anIconWithoutAPaletteFollowsTheProgram) {
    const QPalette before = QGuiApplication::palette();
    const QIcon undo = icon(IconName::Undo);
    for (const QColor color : {Qt::red, Qt::blue}) {
        QGuiApplication::setPalette(paletteOf(color, Qt::gray, Qt::white));
        EXPECT_EQ(colorsOf(imageOf(undo, 48)), std::set{color.rgba()});
    }
    QGuiApplication::setPalette(before);
}

TEST(Icons, everyScaleIsRenderedInItsOwnPixels) {
    for (const qreal ratio : {1.0, 1.5, 2.0, 3.0}) {
        const QPixmap pixmap = icon(IconName::Grid).pixmap(QSize(24, 24), ratio);
        EXPECT_EQ(pixmap.size(), QSize(24, 24) * ratio);
        EXPECT_EQ(pixmap.devicePixelRatio(), ratio);
    }
    // Straight lines of 1.5 units, drawn as wide as two whole pixels or more, have sharp middles at every scale.
    EXPECT_GT(inkOf(imageOf(icon(IconName::Grid), 24, 2)), 3 * inkOf(imageOf(icon(IconName::Grid), 24, 1)));
}

TEST(Icons, paintingOnAScaledDeviceEqualsThePixmapOfThatScale) {
    const QIcon grid = icon(IconName::Grid);
    QImage canvas(48, 48, QImage::Format_ARGB32_Premultiplied);
    canvas.setDevicePixelRatio(2);
    canvas.fill(Qt::transparent);
    QPainter painter(&canvas);
    grid.paint(&painter, 0, 0, 24, 24);
    painter.end();
    canvas.setDevicePixelRatio(1);
    QImage expected = imageOf(grid, 24, 2);
    expected.setDevicePixelRatio(1);
    EXPECT_EQ(canvas.convertToFormat(QImage::Format_ARGB32), expected);
}

TEST(Icons, theApplicationIconKeepsItsColours) {
    EXPECT_GT(colorsOf(imageOf(applicationIcon(), 64)).size(), 10U);
    EXPECT_GT(inkOf(imageOf(applicationIcon(), 16)), 100);
}

} // namespace
} // namespace kriva::ui
