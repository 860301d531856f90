#pragma once

#include "ui/window/shortcut_sheet.h"

#include <QDialog>

#include <functional>

class QDialogButtonBox;
class QLineEdit;
class QTreeWidget;

namespace kriva::ui {

/// The sheet of shortcuts, with a field that narrows it. It stays open beside the window.
class ShortcutsDialog : public QDialog {
    Q_OBJECT
  public:
    using Sheet = std::function<std::vector<ShortcutGroup>()>;
    /// `sheet` gives the shortcuts in the present language.
    explicit ShortcutsDialog(Sheet sheet, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();
    void fill();
    void narrow();

    Sheet sheet_;
    QLineEdit* filter_;
    QTreeWidget* list_;
    QDialogButtonBox* buttons_;
};

} // namespace kriva::ui
