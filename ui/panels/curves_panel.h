#pragma once

#include "ui/panels/curves_model.h"

#include <QListView>
#include <QToolButton>

namespace kriva::ui {

class StyleEditor;

/// The curves of a sheet: choose the active one, show and hide, rename, colour, style, add, duplicate, delete, reorder.
class CurvesPanel : public QWidget {
    Q_OBJECT
  public:
    explicit CurvesPanel(SheetEditor& editor, QWidget* parent = nullptr);

    /// Lets the name of the active curve be typed.
    void beginRenaming();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void connectButtons();
    void retranslateUi();
    void showState();
    void chooseColor();

    SheetEditor& editor_;
    CurvesModel model_;
    QListView* list_;
    QToolButton* add_;
    QToolButton* duplicate_;
    QToolButton* delete_;
    QToolButton* up_;
    QToolButton* down_;
    QToolButton* color_;
    QToolButton* style_;
    StyleEditor* styleEditor_;
};

} // namespace kriva::ui
