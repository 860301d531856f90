#pragma once

#include <QDialog>

class QDialogButtonBox;
class QLabel;

namespace kriva::ui {

/// What Kriva is, its version, its licence and what it is built on. It stays open beside the window.
class AboutDialog : public QDialog {
    Q_OBJECT
  public:
    explicit AboutDialog(QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void retranslateUi();

    QLabel* text_;
    QLabel* details_;
    QDialogButtonBox* buttons_;
};

} // namespace kriva::ui
