#pragma once

#include <QProxyStyle>

namespace kriva::ui {

/// Fusion, mended where it does not follow a dark palette: the buttons of panels and tool bars have icons of ours, tool
/// bars and headers are flat, and the frames of check boxes and radio buttons can be seen. Alt alone goes to no menu:
/// on the canvas it is held for gestures.
class ThemeStyle : public QProxyStyle {
    Q_OBJECT
  public:
    ThemeStyle();

    [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                                QStyleHintReturn* data) const override;
    [[nodiscard]] QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                                     const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
};

} // namespace kriva::ui
