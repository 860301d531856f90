#pragma once

#include "ui/figures/figure_file.h"
#include "ui/figures/figure_preview.h"
#include "ui/panels/controls/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

namespace kriva::ui {

/// How the figure of a sheet is to be written, with the figure beside it as it will be.
class ExportDialog : public QDialog {
    Q_OBJECT
  public:
    ExportDialog(Document document, SheetIndex sheet, const FigureFileOptions& options, QWidget* parent = nullptr);

    [[nodiscard]] FigureFileOptions options() const;

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fill(const FigureFileOptions& options);
    void layOut();
    void addRow(QWidget* field);
    void fillLayers(const DrawingOptions& drawing);
    void connectFields();
    void retranslateUi();
    void setRowText(QWidget* field, const QString& text);
    /// What only some formats have is there for them alone.
    void showFormat();
    void showDrawing();
    [[nodiscard]] FigureFormat format() const;
    /// Whether the active curve has an animation.
    [[nodiscard]] bool hasFrames() const;
    [[nodiscard]] Drawing drawing(const FigureFileOptions& wanted) const;
    [[nodiscard]] std::vector<std::string> checkedLayers() const;

    const Document document_;
    const SheetIndex sheet_;
    FigurePreview* preview_;
    QFormLayout* form_;
    QComboBox* format_;
    QCheckBox* hasOwnWidth_;
    NumberField* width_;
    QCheckBox* hasOwnScale_;
    NumberField* scale_;
    NumberField* margin_;
    QLabel* size_;
    QComboBox* theme_;
    QCheckBox* hasTexts_;
    QListWidget* layers_;
    QCheckBox* holdsDocument_;
    QCheckBox* hasInkscapeLayers_;
    QCheckBox* hasOutlines_;
    QCheckBox* isRounded_;
    NumberField* decimals_;
    NumberField* dpi_;
    QCheckBox* isTransparent_;
    QCheckBox* isFragment_;
    QLineEdit* frames_;
    QCheckBox* isAnimated_;
    NumberField* frameSeconds_;
    QDialogButtonBox* buttons_;
};

} // namespace kriva::ui
