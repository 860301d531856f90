#pragma once

#include <QListWidget>

namespace kriva::ui {

class SheetEditor;

/// Turns the layers of a sheet on and off.
class LayersPanel : public QListWidget {
    Q_OBJECT
  public:
    explicit LayersPanel(SheetEditor& editor, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();
    void showState();

    SheetEditor& editor_;
};

} // namespace kriva::ui
