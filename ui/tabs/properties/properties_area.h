#pragma once

#include <QScrollArea>

namespace kriva::ui {

/// Lets tall properties scroll in a small window, but never cuts them off at the side: it asks for the width that they
/// need in the present language.
class PropertiesArea : public QScrollArea {
    Q_OBJECT
  public:
    explicit PropertiesArea(QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace kriva::ui
