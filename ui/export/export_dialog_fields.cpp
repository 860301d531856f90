#include "ui/export/export_dialog.h"
#include "ui/figures/caption_text.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace kriva::ui {
namespace {

constexpr double kLeastWidth = 5;
constexpr double kMostWidth = 2000;
constexpr double kMostMargin = 100;
constexpr double kUsualDecimals = 3;

} // namespace

void ExportDialog::fill(const FigureFileOptions& options) {
    for (const auto& [name, format] : kFormatNames)
        if (subject_.isSheet || format != FigureFormat::csv)
            format_->addItem(QString(), static_cast<int>(format));
    format_->setCurrentIndex(format_->findData(static_cast<int>(options.format)));
    theme_->addItems({QString(), QString()});
    theme_->setCurrentIndex(options.drawing.theme == Theme::dark ? 1 : 0);
    margin_->setRange({0, kMostMargin});
    margin_->setValue(options.drawing.margin);
    width_->setRange({kLeastWidth, kMostWidth});
    width_->setValue(options.drawing.width.value_or(kLeastWidth)); // showDrawing() tells the figure's own
    hasOwnWidth_->setChecked(options.drawing.width.has_value());
    scale_->setRange({kLeastScale, kMostScale});
    scale_->setValue(options.drawing.mmPerUnit.value_or(1));
    hasOwnScale_->setChecked(options.drawing.mmPerUnit.has_value() && !options.drawing.width);
    hasTexts_->setChecked(options.drawing.hasLabels);
    holdsDocument_->setChecked(options.holdsDocument);
    hasInkscapeLayers_->setChecked(options.hasInkscapeLayers);
    hasOutlines_->setChecked(options.hasOutlines);
    isRounded_->setChecked(options.decimals.has_value());
    decimals_->setRange({0, kMostDecimals, false, true});
    decimals_->setValue(options.decimals.value_or(kUsualDecimals));
    dpi_->setRange({kLeastDpi, kMostDpi, false, true});
    dpi_->setValue(options.dpi);
    isTransparent_->setChecked(options.isTransparent);
    isFragment_->setChecked(options.tikz == TikzKind::fragment);
    frames_->setFrames(options.frames);
    isAnimated_->setChecked(options.isAnimated);
    frameSeconds_->setRange({kLeastFrameSeconds, kMostFrameSeconds});
    frameSeconds_->setValue(options.frameSeconds);
    fillLayers(options.drawing);
}

void ExportDialog::layOut() {
    for (QWidget* field :
         std::initializer_list<QWidget*>{format_,      hasOwnWidth_, width_,        hasOwnScale_,   scale_,
                                         margin_,      size_,        theme_,        hasTexts_,      layers_,
                                         frames_,      isAnimated_,  frameSeconds_, holdsDocument_, hasInkscapeLayers_,
                                         hasOutlines_, isRounded_,   decimals_,     dpi_,           isTransparent_,
                                         isFragment_})
        qobject_cast<QCheckBox*>(field) ? form_->addRow(field) : form_->addField(field);
    auto* fields = new QVBoxLayout;
    fields->addLayout(form_);
    fields->addStretch(1);
    auto* both = new QHBoxLayout;
    both->addWidget(preview_, 1);
    both->addLayout(fields);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(both, 1);
    layout->addWidget(buttons_);
}

void ExportDialog::fillLayers(const DrawingOptions& drawing) {
    for (const ExportSubject::LayerChoice& layer : subject_.layers) {
        auto* item = new QListWidgetItem(layers_);
        const bool isChosen =
            drawing.layers ? std::ranges::find(*drawing.layers, layer.name) != drawing.layers->end() : layer.isShown;
        item->setCheckState(isChosen ? Qt::Checked : Qt::Unchecked);
    }
    layers_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
}

void ExportDialog::retranslateUi() {
    setWindowTitle(tr("Export figure"));
    const QStringList formats{tr("SVG figure"), tr("PDF page"), tr("PNG picture"), tr("TikZ for LaTeX"),
                              tr("CSV of the points")};
    for (int i = 0; i < format_->count(); ++i)
        format_->setItemText(i, formats[i]);
    theme_->setItemText(0, tr("Light"));
    theme_->setItemText(1, tr("Dark"));
    for (int i = 0; i < layers_->count(); ++i)
        layers_->item(i)->setText(captionText(subject_.layers[static_cast<std::size_t>(i)].caption));
    form_->setLabel(format_, tr("&Format"));
    form_->setLabel(width_, tr("Width (mm)"));
    form_->setLabel(scale_, tr("Scale (mm for a unit)"));
    form_->setLabel(margin_, tr("&Margin (mm)"));
    form_->setLabel(size_, tr("Page"));
    form_->setLabel(theme_, tr("&Colours"));
    form_->setLabel(layers_, tr("La&yers"));
    form_->setLabel(frames_, tr("Fra&mes"));
    form_->setLabel(frameSeconds_, tr("Seconds of &a frame"));
    form_->setLabel(decimals_, tr("D&ecimals"));
    form_->setLabel(dpi_, tr("&Dots per inch"));
    frames_->setPlaceholderText(tr("0; 5; 10 or 0..10 or t = 0.25; 0.5"));
    isAnimated_->setText(tr("A&nimated"));
    hasOwnWidth_->setText(tr("Set the &width"));
    hasTexts_->setText(tr("Text&s in the figure"));
    hasOwnScale_->setText(tr("Set the scale"));
    holdsDocument_->setText(tr("The document &goes along, to open the file again"));
    hasInkscapeLayers_->setText(tr("Layers for &Inkscape"));
    hasOutlines_->setText(tr("O&utlines in place of letters"));
    isRounded_->setText(tr("&Round coordinates"));
    isTransparent_->setText(tr("&Transparent"));
    isFragment_->setText(tr("A &part for another document"));
    preview_->setAccessibleName(tr("The figure as it will be"));
    buttons_->button(QDialogButtonBox::Save)->setText(tr("E&xport…"));
}

std::optional<std::vector<std::string>> ExportDialog::checkedLayers() const {
    std::vector<std::string> checked;
    bool isAsShown = true;
    for (int i = 0; i < layers_->count(); ++i) {
        const ExportSubject::LayerChoice& layer = subject_.layers[static_cast<std::size_t>(i)];
        const bool isChecked = layers_->item(i)->checkState() == Qt::Checked;
        isAsShown = isAsShown && isChecked == layer.isShown;
        if (isChecked)
            checked.emplace_back(layer.name);
    }
    return isAsShown ? std::nullopt : std::optional(std::move(checked));
}

FigureFileOptions ExportDialog::options() const {
    FigureFileOptions options;
    options.format = format();
    options.drawing.margin = margin_->value();
    // A page is wider than its margins.
    if (hasOwnWidth_->isChecked())
        options.drawing.width = std::max(width_->value(), 2 * margin_->value() + kLeastWidth);
    if (hasOwnScale_->isChecked())
        options.drawing.mmPerUnit = scale_->value();
    options.drawing.layers = checkedLayers();
    options.drawing.hasLabels = hasTexts_->isChecked();
    options.drawing.theme = theme_->currentIndex() == 1 ? Theme::dark : Theme::light;
    options.holdsDocument = holdsDocument_->isChecked();
    options.hasInkscapeLayers = hasInkscapeLayers_->isChecked();
    options.hasOutlines = hasOutlines_->isChecked();
    if (isRounded_->isChecked())
        options.decimals = static_cast<int>(decimals_->value());
    options.dpi = static_cast<int>(dpi_->value());
    options.isTransparent = isTransparent_->isChecked();
    options.tikz = isFragment_->isChecked() ? TikzKind::fragment : TikzKind::standalone;
    if (subject_.hasFrames)
        options.frames = frames_->frames();
    options.isAnimated = isAnimated_->isChecked() && !options.frames.empty() && options.format == FigureFormat::svg;
    options.frameSeconds = frameSeconds_->value();
    return options;
}

} // namespace kriva::ui
