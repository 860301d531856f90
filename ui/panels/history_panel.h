#pragma once

#include <QListWidget>

namespace kriva::ui {

class SheetEditor;

/// The steps of a sheet, in the words of the present language; a click goes back or forth to one.
class HistoryPanel : public QListWidget {
    Q_OBJECT
  public:
    explicit HistoryPanel(SheetEditor& editor, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();
    void showState();

    SheetEditor& editor_;
};

} // namespace kriva::ui
