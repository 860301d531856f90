#pragma once

#include "ui/controls/labelled_form.h"
#include "ui/controls/number_field.h"
#include "ui/editing/results/coalescing_worker.h"
#include "ui/export/export_subject.h"
#include "ui/export/frames_field.h"
#include "ui/figures/figure_file.h"
#include "ui/figures/figure_preview.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>

namespace kriva::ui {

/// How a figure is to be written, with the figure beside it as it will be.
class ExportDialog : public QDialog {
    Q_OBJECT
  public:
    /// The figure is made on the threads of the pool, which outlives the dialog.
    ExportDialog(ExportSubject subject, const FigureFileOptions& options, QThreadPool& workers,
                 QWidget* parent = nullptr);

    [[nodiscard]] FigureFileOptions options() const;

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fill(const FigureFileOptions& options);
    void layOut();
    void fillLayers(const DrawingOptions& drawing);
    void connectFields();
    void retranslateUi();
    /// What only some formats have is there for them alone.
    void showFormat();
    /// The figure for what the fields say now, on any thread.
    [[nodiscard]] CoalescingWorker::Work drawing();
    void showDrawing(Drawing drawing);
    [[nodiscard]] FigureFormat format() const;
    /// Nothing where they are those on view, so that frames show what their stages bring.
    [[nodiscard]] std::optional<std::vector<std::string>> checkedLayers() const;

    const ExportSubject subject_;
    CoalescingWorker drawing_;
    FigurePreview* preview_;
    LabelledForm* form_;
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
    FramesField* frames_;
    QCheckBox* isAnimated_;
    NumberField* frameSeconds_;
    QDialogButtonBox* buttons_;
};

} // namespace kriva::ui
