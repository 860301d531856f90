#include "ui/tabs/properties/properties_panel.h"

#include "ui/base/look/plain_label.h"
#include "ui/controls/focused_wheel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QSignalBlocker>

namespace kriva::ui {

PropertiesPanel::PropertiesPanel(SheetEditor& editor, QWidget* parent)
    : QWidget(parent)
    , editor_(editor)
    , layout_(new QFormLayout(this)) {
    layout_->setRowWrapPolicy(QFormLayout::WrapLongRows);
    layout_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    layout_->setLabelAlignment(Qt::AlignLeft);
    connect(&editor.document(), &OpenDocument::replaced, this, &PropertiesPanel::showState);
    connect(&editor.document(), &OpenDocument::refused, this, &PropertiesPanel::showState);
    const auto ifMine = [this](SheetIndex sheet) {
        if (sheet == editor_.index())
            showState();
    };
    connect(&editor.document(), &OpenDocument::curvesChanged, this, ifMine);
    connect(&editor.document(), &OpenDocument::viewChanged, this, ifMine);
    connect(&editor, &SheetEditor::selectionChanged, this, &PropertiesPanel::showState);
    connect(&editor, &SheetEditor::shownCurveChanged, this, [this](Serial serial) {
        if (serial == editor_.activeSerial())
            showState();
    });
}

void PropertiesPanel::addRow(const char* label, QWidget* field) {
    auto* text = new PlainLabel(this);
    text->setBuddy(field);
    layout_->addRow(text, field);
    takeWheelWithFocusOnly(*field);
    rows_.push_back({text, label, field});
}

void PropertiesPanel::addWide(QWidget* widget) {
    layout_->addRow(widget);
}

void PropertiesPanel::addHeading(const char* label) {
    auto* text = new PlainLabel(this);
    QFont bold = text->font();
    bold.setBold(true);
    text->setFont(bold);
    text->setContentsMargins(0, 8, 0, 0);
    text->setWordWrap(true);
    layout_->addRow(text);
    rows_.push_back({text, label, nullptr});
}

void PropertiesPanel::bind(SliderField* field, const Change& change, const StepLabel& step) {
    OpenDocument& document = editor_.document();
    connect(field, &SliderField::dragStarted, this,
            [this, &document, step] { document.beginGesture(editor_.index(), editor_.activeSerial(), step); });
    connect(field, &SliderField::valueDragged, this, [&document, change](double value) {
        if (document.hasGesture())
            document.preview(change(document.gestureStart(), value));
    });
    connect(field, &SliderField::dragEnded, &document, &OpenDocument::endGesture);
    connect(field, &SliderField::valueStepped, this,
            [this, change, step](double value) { editor_.changeInBurst(change(*editor_.activeCurve(), value), step); });
    connect(field, &SliderField::valueTyped, this,
            [this, change, step](double value) { editor_.change(change(*editor_.activeCurve(), value), step); });
}

void PropertiesPanel::bindView(SliderField* field, const std::function<void(double)>& set) {
    connect(field, &SliderField::valueDragged, this, set);
    connect(field, &SliderField::valueStepped, this, set);
    connect(field, &SliderField::valueTyped, this, set);
}

QCheckBox* PropertiesPanel::addLayerBox(std::string_view layer) {
    auto* box = new QCheckBox(this);
    connect(box, &QCheckBox::toggled, this,
            [this, layer](bool on) { editor_.document().setLayerShown(editor_.index(), layer, on); });
    layerBoxes_.push_back({box, layer});
    addWide(box);
    return box;
}

void PropertiesPanel::showLayerBoxes() {
    for (const LayerBox& row : layerBoxes_) {
        const QSignalBlocker blocker(row.box);
        for (const LayerInfo& layer : layersOf(editor_.index()))
            if (layer.name == row.layer)
                row.box->setChecked(isShown(layer, editor_.sheet().view));
    }
}

QPushButton* PropertiesPanel::addButton(const char* label, const std::function<void()>& run) {
    auto* button = new QPushButton(this);
    connect(button, &QPushButton::clicked, this, run);
    buttons_.push_back({button, label});
    addWide(button);
    return button;
}

QComboBox* PropertiesPanel::addChoice(const char* label, std::vector<const char*> entries, const Change& change,
                                      const StepLabel& step) {
    auto* box = new QComboBox(this);
    for (std::size_t i = 0; i < entries.size(); ++i)
        box->addItem(QString());
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents); // also when a switch of the language makes texts longer
    connect(box, &QComboBox::activated, this,
            [this, change, step](int index) { editor_.change(change(*editor_.activeCurve(), index), step); });
    choices_.push_back({box, std::move(entries)});
    addRow(label, box);
    return box;
}

void PropertiesPanel::finish() {
    retranslateUi();
}

void PropertiesPanel::showState() {
    const bool isThere = editor_.activeCurve() != nullptr;
    setEnabled(isThere);
    showLayerBoxes();
    isThere ? showCurve() : showNoCurve();
}

void PropertiesPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

void PropertiesPanel::retranslateUi() {
    const auto translated = [](const char* text) { return QCoreApplication::translate("Properties", text); };
    for (const Row& row : rows_) {
        row.label->setText(translated(row.text));
        if (auto* slider = qobject_cast<SliderField*>(row.field))
            slider->setAccessibleTexts(translated(row.text), tr("Less"), tr("More"));
        else if (row.field)
            row.field->setAccessibleName(translated(row.text));
    }
    for (const Choice& choice : choices_)
        for (std::size_t i = 0; i < choice.entries.size(); ++i)
            choice.box->setItemText(static_cast<int>(i), translated(choice.entries[i]));
    for (const Button& row : buttons_)
        row.button->setText(translated(row.text));
    retranslateFields();
    showState();
}

} // namespace kriva::ui
