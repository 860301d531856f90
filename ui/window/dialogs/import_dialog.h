#pragma once

#include "core/io/svg/imported.h"
#include "ui/controls/labelled_form.h"
#include "ui/controls/number_field.h"
#include "ui/figures/figure_preview.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>

namespace kriva::ui {

/// Which of the paths of a file become curves of a sheet, how large and where, with the curves beside it as they will
/// be.
class ImportDialog : public QDialog {
    Q_OBJECT
  public:
    ImportDialog(std::vector<ImportedPath> paths, SheetIndex sheet, QWidget* parent = nullptr);

    /// Those chosen, at their place; none while they are beyond the limits of the model.
    [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fill();
    void layOut();
    void retranslateUi();
    void showCurves();
    /// Places of the chosen ones among all.
    [[nodiscard]] std::vector<int> chosen() const;
    [[nodiscard]] QString nameOfPath(int index) const;

    const std::vector<ImportedPath> paths_;
    const SheetIndex sheet_;
    std::vector<Curve> curves_;
    FigurePreview* preview_;
    QListWidget* list_;
    QLabel* listLabel_;
    LabelledForm* form_;
    NumberField* scale_;
    NumberField* x_;
    NumberField* y_;
    QLabel* told_;
    QDialogButtonBox* buttons_;
};

} // namespace kriva::ui
