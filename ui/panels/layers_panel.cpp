#include "ui/panels/layers_panel.h"

#include "ui/editing/sheet_editor.h"
#include "ui/figures/caption_text.h"

#include <QEvent>
#include <QSignalBlocker>

namespace kriva::ui {

LayersPanel::LayersPanel(SheetEditor& editor, QWidget* parent)
    : QListWidget(parent)
    , editor_(editor) {
    setObjectName(QStringLiteral("layers"));
    setFrameShape(QFrame::NoFrame);
    for (std::size_t i = 0; i < layersOf(editor.index()).size(); ++i)
        addItem(QString());
    connect(this, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        const LayerInfo& layer = layersOf(editor_.index())[static_cast<std::size_t>(row(item))];
        editor_.document().setLayerShown(editor_.index(), layer.name, item->checkState() == Qt::Checked);
    });
    connect(&editor.document(), &OpenDocument::viewChanged, this, &LayersPanel::showState);
    connect(&editor.document(), &OpenDocument::replaced, this, &LayersPanel::showState);
    retranslateUi();
}

void LayersPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QListWidget::changeEvent(event);
}

void LayersPanel::retranslateUi() {
    setAccessibleName(tr("Layers"));
    showState();
}

void LayersPanel::showState() {
    const QSignalBlocker blocker(this);
    const auto layers = layersOf(editor_.index());
    for (int i = 0; i < count(); ++i) {
        const LayerInfo& layer = layers[static_cast<std::size_t>(i)];
        item(i)->setText(captionText(layer.caption));
        item(i)->setCheckState(isShown(layer, editor_.sheet().view) ? Qt::Checked : Qt::Unchecked);
    }
}

} // namespace kriva::ui
