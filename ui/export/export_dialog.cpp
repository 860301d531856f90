#include "ui/export/export_dialog.h"

#include "core/curve/limits.h"
#include "ui/base/look/plain_label.h"

#include <QEvent>
#include <QLocale>

#include <utility>

namespace kriva::ui {
namespace {

/// For people: to four digits.
double rounded(double value) {
    return QString::number(value, 'g', 4).toDouble();
}

} // namespace

ExportDialog::ExportDialog(ExportSubject subject, const FigureFileOptions& options, QThreadPool& workers,
                           QWidget* parent)
    : QDialog(parent)
    , subject_(std::move(subject))
    , drawing_(
          workers, [this] { return drawing(); }, limits::kSteps)
    , preview_(new FigurePreview(this))
    , form_(new LabelledForm)
    , format_(new QComboBox(this))
    , hasOwnWidth_(new QCheckBox(this))
    , width_(new NumberField(this))
    , hasOwnScale_(new QCheckBox(this))
    , scale_(new NumberField(this))
    , margin_(new NumberField(this))
    , size_(new PlainLabel(this))
    , theme_(new QComboBox(this))
    , hasTexts_(new QCheckBox(this))
    , layers_(new QListWidget(this))
    , holdsDocument_(new QCheckBox(this))
    , hasInkscapeLayers_(new QCheckBox(this))
    , hasOutlines_(new QCheckBox(this))
    , isRounded_(new QCheckBox(this))
    , decimals_(new NumberField(this))
    , dpi_(new NumberField(this))
    , isTransparent_(new QCheckBox(this))
    , isFragment_(new QCheckBox(this))
    , frames_(new FramesField(this))
    , isAnimated_(new QCheckBox(this))
    , frameSeconds_(new NumberField(this))
    , buttons_(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this)) {
    fill(options);
    layOut();
    connectFields();
    retranslateUi();
    showFormat();
}

void ExportDialog::connectFields() {
    connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::showFormat);
    connect(theme_, &QComboBox::currentIndexChanged, &drawing_, &CoalescingWorker::doSoon);
    connect(layers_, &QListWidget::itemChanged, &drawing_, &CoalescingWorker::doSoon);
    connect(frames_, &QLineEdit::textChanged, this, &ExportDialog::showFormat);
    // One of them decides.
    connect(hasOwnWidth_, &QCheckBox::toggled, this,
            [this](bool on) { hasOwnScale_->setChecked(hasOwnScale_->isChecked() && !on); });
    connect(hasOwnScale_, &QCheckBox::toggled, this,
            [this](bool on) { hasOwnWidth_->setChecked(hasOwnWidth_->isChecked() && !on); });
    for (QCheckBox* box : {hasOwnWidth_, hasOwnScale_, hasTexts_, isAnimated_, isRounded_, isTransparent_})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::showFormat);
    for (NumberField* field : {width_, scale_, margin_, frameSeconds_, decimals_, dpi_})
        connect(field, &NumberField::valueCommitted, &drawing_, &CoalescingWorker::doSoon);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslateUi();
        drawing_.doSoon();
    }
    QDialog::changeEvent(event);
}

void ExportDialog::showFormat() {
    const FigureFormat shown = format();
    const bool isFigure = shown != FigureFormat::csv;
    const bool isSvg = shown == FigureFormat::svg;
    const auto show = [this](std::initializer_list<QWidget*> fields, bool isVisible) {
        for (QWidget* field : fields)
            form_->setRowVisible(field, isVisible);
    };
    show({hasOwnWidth_, width_, margin_, size_, theme_, hasTexts_, layers_}, isFigure);
    show({hasOwnScale_, scale_}, isFigure && subject_.isSheet);
    show({frames_}, isFigure && subject_.hasFrames);
    const bool mayBeAnimated = isSvg && subject_.hasFrames && !frames_->text().trimmed().isEmpty();
    show({isAnimated_}, mayBeAnimated);
    show({frameSeconds_}, mayBeAnimated && isAnimated_->isChecked());
    show({holdsDocument_}, isSvg && subject_.isSheet);
    show({hasInkscapeLayers_, hasOutlines_, isRounded_, decimals_}, isSvg);
    show({dpi_, isTransparent_}, shown == FigureFormat::png);
    show({isFragment_}, shown == FigureFormat::tikz);
    width_->setEnabled(hasOwnWidth_->isChecked());
    scale_->setEnabled(hasOwnScale_->isChecked());
    decimals_->setEnabled(isRounded_->isChecked());
    drawing_.doSoon();
}

CoalescingWorker::Work ExportDialog::drawing() {
    return [this, make = subject_.drawing, wanted = options()](WorkBudget& budget) -> CoalescingWorker::Take {
        Drawing made = make(wanted, budget);
        made.hasPaper = hasPaper(wanted);
        return [this, made = std::move(made)]() mutable { showDrawing(std::move(made)); };
    };
}

void ExportDialog::showDrawing(Drawing drawing) {
    const Page& page = drawing.page;
    const QLocale locale;
    size_->setText(tr("%1 × %2 mm").arg(locale.toString(page.width, 'g', 4), locale.toString(page.height, 'g', 4)));
    if (!hasOwnWidth_->isChecked())
        width_->setValue(rounded(page.width));
    if (!hasOwnScale_->isChecked())
        scale_->setValue(rounded(page.mmPerUnit));
    preview_->setDrawing(std::move(drawing));
}

FigureFormat ExportDialog::format() const {
    return static_cast<FigureFormat>(format_->currentData().toInt());
}

} // namespace kriva::ui
