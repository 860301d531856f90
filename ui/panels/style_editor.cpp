#include "ui/panels/style_editor.h"

#include "core/figure/role_style.h"
#include "ui/controls/labelled_form.h"
#include "ui/controls/number_field.h"
#include "ui/editing/sheet_editor.h"

#include <QCoreApplication>
#include <QEvent>

#include <array>

namespace kriva::ui {
namespace {

constexpr double kWidthStep = 0.1; // points

// In the order of LineDash.
constexpr std::array kDashTexts{QT_TRANSLATE_NOOP("StyleEditor", "Solid"), QT_TRANSLATE_NOOP("StyleEditor", "Dashed"),
                                QT_TRANSLATE_NOOP("StyleEditor", "Dotted"),
                                QT_TRANSLATE_NOOP("StyleEditor", "Dash-dot")};
// Behind the role's own, in the order of Marker, but without the ring.
constexpr std::array kMarkerTexts{QT_TRANSLATE_NOOP("StyleEditor", "As usual"),
                                  QT_TRANSLATE_NOOP("StyleEditor", "None"), QT_TRANSLATE_NOOP("StyleEditor", "Circles"),
                                  QT_TRANSLATE_NOOP("StyleEditor", "Squares"),
                                  QT_TRANSLATE_NOOP("StyleEditor", "Diamonds")};

template <std::size_t size>
void fill(QComboBox& box, const std::array<const char*, size>& texts) {
    const int current = box.currentIndex();
    box.clear();
    for (const char* text : texts)
        box.addItem(QCoreApplication::translate("StyleEditor", text));
    box.setCurrentIndex(current);
}

} // namespace

StyleEditor::StyleEditor(SheetEditor& editor, QWidget* parent)
    : QWidget(parent)
    , editor_(editor)
    , form_(new LabelledForm(this))
    , width_(new NumberField(this))
    , dash_(new QComboBox(this))
    , marker_(new QComboBox(this))
    , labels_(new QCheckBox(this))
    , reset_(new QPushButton(this)) {
    form_->setContentsMargins(4, 2, 4, 4);
    width_->setRange({kLeastWidth, kMostWidth});
    width_->setStep(kWidthStep);
    for (QWidget* field : std::initializer_list<QWidget*>{width_, dash_, marker_})
        form_->addField(field);
    form_->addRow(labels_);
    form_->addRow(reset_);
    connectFields();
    retranslateUi();
}

void StyleEditor::connectFields() {
    connect(width_, &NumberField::valueCommitted, this, [this](double width) {
        CurveStyle changed = style();
        changed.width = width;
        change(changed, {QT_TRANSLATE_NOOP("Step", "Set the width of the line")});
    });
    connect(dash_, &QComboBox::activated, this, [this](int index) {
        CurveStyle changed = style();
        changed.dash = static_cast<LineDash>(index);
        if (changed.dash == LineDash::solid) // as every curve's line is
            changed.dash.reset();
        change(changed, {QT_TRANSLATE_NOOP("Step", "Set the dashes of the line")});
    });
    connect(marker_, &QComboBox::activated, this, [this](int index) {
        CurveStyle changed = style();
        changed.marker = index == 0 ? std::nullopt : std::optional(static_cast<Marker>(index - 1));
        change(changed, {QT_TRANSLATE_NOOP("Step", "Set the marks of the points")});
    });
    connect(labels_, &QCheckBox::clicked, this, [this](bool isOn) {
        CurveStyle changed = style();
        changed.hasLabels = isOn;
        change(changed, isOn ? StepLabel{QT_TRANSLATE_NOOP("Step", "Show the labels")}
                             : StepLabel{QT_TRANSLATE_NOOP("Step", "Hide the labels")});
    });
    connect(reset_, &QPushButton::clicked, this,
            [this] { change({}, {QT_TRANSLATE_NOOP("Step", "Reset the style")}); });
    connect(&editor_.document(), &OpenDocument::replaced, this, &StyleEditor::showState);
    connect(&editor_.document(), &OpenDocument::curvesChanged, this, &StyleEditor::showState);
    connect(&editor_.document(), &OpenDocument::viewChanged, this, &StyleEditor::showState);
    connect(&editor_.document(), &OpenDocument::curveChanged, this, &StyleEditor::showState);
}

void StyleEditor::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    QWidget::changeEvent(event);
}

void StyleEditor::retranslateUi() {
    form_->setLabel(width_, tr("Width of the line"));
    form_->setLabel(dash_, tr("Line"));
    form_->setLabel(marker_, tr("Marks of the points"));
    labels_->setText(tr("Labels"));
    labels_->setAccessibleName(tr("Labels"));
    reset_->setText(tr("Usual style"));
    reset_->setAccessibleName(tr("Usual style"));
    fill(*dash_, kDashTexts);
    fill(*marker_, kMarkerTexts);
    showState();
}

void StyleEditor::showState() {
    setEnabled(editor_.activeCurve() != nullptr);
    const CurveStyle shown = style();
    width_->setValue(shown.width.value_or(styleOf(Role::curve, 0, Theme::light).width));
    dash_->setCurrentIndex(static_cast<int>(shown.dash.value_or(LineDash::solid)));
    marker_->setCurrentIndex(shown.marker ? static_cast<int>(*shown.marker) + 1 : 0);
    labels_->setChecked(shown.hasLabels);
    reset_->setEnabled(shown != CurveStyle());
}

CurveStyle StyleEditor::style() const {
    const Curve* curve = editor_.activeCurve();
    return curve ? styleOf(*curve) : CurveStyle();
}

void StyleEditor::change(const CurveStyle& style, const StepLabel& label) {
    editor_.styleCurve(editor_.activeSerial(), style, label);
}

} // namespace kriva::ui
