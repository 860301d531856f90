#include "ui/base/look/theme_style.h"

#include "ui/base/look/icons.h"
#include "ui/base/look/theme.h"

#include <QPainter>
#include <QStyleOption>

namespace kriva::ui {
namespace {

/// Fusion frames an indicator in the window's colour made darker by half, which is next to nothing on a dark window.
/// This is the window's colour for which the frame comes out in that of pale text.
[[nodiscard]] QColor windowForFrame(const QStyleOption& option) {
    const QColor frame = option.palette.color(QPalette::PlaceholderText);
    return option.state.testFlag(QStyle::State_Enabled) ? frame.lighter(150) : frame;
}

/// Fusion's bevels are white lines, and so transparent that other threads blend them, pixel by pixel.
void drawFlat(QPainter& painter, const QStyleOption& option, QPalette::ColorRole ground) {
    painter.fillRect(option.rect, option.palette.brush(ground));
    painter.fillRect(QRect(option.rect.bottomLeft(), QSize(option.rect.width(), 1)), option.palette.mid());
}
void drawRightEdge(QPainter& painter, const QStyleOption& option) {
    painter.fillRect(QRect(option.rect.topRight(), QSize(1, option.rect.height())), option.palette.mid());
}

} // namespace

ThemeStyle::ThemeStyle()
    : QProxyStyle(QStringLiteral("Fusion")) {}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* data) const {
    return hint == SH_MenuBar_AltKeyNavigation ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
}

QIcon ThemeStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
    switch (which) {
    case SP_TitleBarCloseButton:
    case SP_DockWidgetCloseButton:
        return icon(IconName::Close);
    case SP_TitleBarNormalButton:
        return icon(IconName::Float);
    case SP_ToolBarHorizontalExtensionButton:
        return icon(IconName::More);
    default:
        return QProxyStyle::standardIcon(which, option, widget);
    }
}

void ThemeStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
    if (element == CE_ToolBar) {
        drawFlat(*painter, *option, QPalette::Window);
    } else if (element == CE_HeaderSection) {
        drawFlat(*painter, *option, QPalette::Button);
        drawRightEdge(*painter, *option);
    } else {
        QProxyStyle::drawControl(element, option, painter, widget);
    }
}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
    const bool isIndicator = element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton;
    if (!button || !isIndicator || !isDark(option->palette))
        return QProxyStyle::drawPrimitive(element, option, painter, widget);
    QStyleOptionButton framed = *button;
    framed.palette.setColor(QPalette::Window, windowForFrame(*option));
    QProxyStyle::drawPrimitive(element, &framed, painter, widget);
}

} // namespace kriva::ui
