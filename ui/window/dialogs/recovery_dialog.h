#pragma once

#include "ui/document/recovery/found_recoveries.h"

#include <QDialog>

#include <span>

class QComboBox;
class QLabel;
class QPushButton;

namespace kriva::ui {

enum class RecoveryChoice { Recover, Discard, Later };

/// Asks, for each document whose unsaved work was found, what is to become of it. Closed without an answer, everything
/// stays for the next start.
class RecoveryDialog : public QDialog {
    Q_OBJECT
  public:
    /// What was found outlives the dialog.
    explicit RecoveryDialog(std::span<const FoundRecovery> found, QWidget* parent = nullptr);

    /// In the order of what was found.
    [[nodiscard]] std::vector<RecoveryChoice> choices() const;

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        const FoundRecovery* found;
        QLabel* name;
        QLabel* place;
        QLabel* damage; ///< null where there is none
        QComboBox* choice;
    };
    [[nodiscard]] QWidget* makeRows(std::span<const FoundRecovery> found);
    [[nodiscard]] Row makeRow(const FoundRecovery& found, QWidget* parent) const;
    static void retranslate(const Row& row);
    [[nodiscard]] static QString damageText(RecoveryState state);
    void retranslateUi();

    QLabel* title_;
    QLabel* text_;
    std::vector<Row> rows_;
    QPushButton* goOn_;
    QPushButton* later_;
};

} // namespace kriva::ui
