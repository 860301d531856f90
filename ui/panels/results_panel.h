#pragma once

#include "core/document/results.h"

#include <QTimer>
#include <QTreeWidget>

namespace kriva::ui {

class SheetEditor;
class SheetRelations;

/// The numbers of the report for the curve on view and for the sheet, live.
class ResultsPanel : public QTreeWidget {
    Q_OBJECT
  public:
    ResultsPanel(SheetEditor& editor, const SheetRelations& relations, QWidget* parent = nullptr);
    /// Computes and shows at once what otherwise waits for the event loop to turn.
    void showState();

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void retranslateUi();
    void showColumns();
    void copy() const;

    SheetEditor& editor_;
    const SheetRelations& relations_;
    QTimer pending_; ///< many changes in one turn of the event loop are one
};

} // namespace kriva::ui
