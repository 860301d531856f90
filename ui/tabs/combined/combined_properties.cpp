#include "ui/tabs/combined/combined_properties.h"

#include "core/sheets/combined/combined.h"

namespace kriva::ui {
namespace {

constexpr int kLastStage = kCombinedStages - 1;
/// Each stage is something to look at.
constexpr double kCalmPace = 0.75;

/// The curve with one member set to another value.
template <class Member>
Curve with(const Curve& curve, Member CombinedCurve::*member, double value) {
    CombinedCurve changed = std::get<CombinedCurve>(curve);
    changed.*member = static_cast<Member>(static_cast<int>(value));
    return Curve(std::move(changed));
}

} // namespace

CombinedProperties::CombinedProperties(SheetEditor& editor, QWidget* parent)
    : PropertiesPanel(editor, parent)
    , degree_(new SliderField(this))
    , automatic_(new QPushButton(this)) {
    method_ = addChoice(QT_TRANSLATE_NOOP("Properties", "Method"),
                        {QT_TRANSLATE_NOOP("Properties", "Approximation"),
                         QT_TRANSLATE_NOOP("Properties", "Interpolation"), QT_TRANSLATE_NOOP("Properties", "Pairs")},
                        [](const Curve& curve, double method) { return with(curve, &CombinedCurve::method, method); },
                        {QT_TRANSLATE_NOOP("Step", "Set the method")});
    addRow(QT_TRANSLATE_NOOP("Properties", "Degree"), degree_);
    degree_->setRange({limits::kFitDegreeLow, limits::kFitDegreeHigh, false, true});
    degree_->setSlider(limits::kFitDegreeLow, limits::kFitDegreeHigh, 1);
    bind(degree_, [](const Curve& curve, double degree) { return with(curve, &CombinedCurve::degree, degree); },
         {QT_TRANSLATE_NOOP("Step", "Set the degree")});
    basis_ = addChoice(QT_TRANSLATE_NOOP("Properties", "Basis"),
                       {QT_TRANSLATE_NOOP("Properties", "Power basis"), QT_TRANSLATE_NOOP("Properties", "Newton basis"),
                        QT_TRANSLATE_NOOP("Properties", "Lagrange basis"),
                        QT_TRANSLATE_NOOP("Properties", "Chebyshev basis")},
                       [](const Curve& curve, double basis) { return with(curve, &CombinedCurve::basis, basis); },
                       {QT_TRANSLATE_NOOP("Step", "Set the basis")});
    addHeading(QT_TRANSLATE_NOOP("Properties", "Corrected pairs"));
    addWide(automatic_);
    connect(automatic_, &QPushButton::clicked, this, &CombinedProperties::dropCorrections);
    makePlayer();
    finish();
}

void CombinedProperties::makePlayer() {
    addHeading(QT_TRANSLATE_NOOP("Properties", "The algorithm step by step"));
    player_ = new Player(this); // here, so that Tab comes to it last
    addWide(player_);
    player_->setKeepable(false); // a stage hides layers: there is nothing to write
    player_->setPace(kCalmPace);
    connect(player_, &Player::stageChanged, this, &CombinedProperties::showStage);
}

void CombinedProperties::showStage(int stage) {
    editor().setLayerStage(stage < kLastStage ? std::optional(stage) : std::nullopt);
    showState();
}

QString CombinedProperties::stageName(int stage) {
    switch (stage) {
    case 0:
        return tr("1 of 5: the given points");
    case 1:
        return tr("2 of 5: monotone runs");
    case 2:
        return tr("3 of 5: a polynomial for each run");
    case 3:
        return tr("4 of 5: joins between the runs");
    default:
        return tr("5 of 5: the whole curve");
    }
}

void CombinedProperties::retranslateFields() {
    automatic_->setText(tr("Back to automatic"));
    automatic_->setToolTip(
        tr("Puts the selected middle points, or all where none is selected, where the tangents meet"));
}

void CombinedProperties::showCurve() {
    const auto& value = curve<CombinedCurve>();
    method_->setCurrentIndex(static_cast<int>(value.method));
    degree_->setValue(value.degree);
    degree_->setEnabled(value.method != CombinedCurve::Method::interpolation);
    basis_->setCurrentIndex(static_cast<int>(value.basis));
    player_->setLast(isIncomplete(value) ? 0 : kLastStage);
    player_->setStage(editor().layerStage().value_or(kLastStage));
    player_->setStageText(stageName(player_->stage()));
    automatic_->setEnabled(!value.corrections.empty() && value.method == CombinedCurve::Method::pairs);
}

void CombinedProperties::dropCorrections() {
    CombinedCurve changed = curve<CombinedCurve>();
    std::vector<int> chosen;
    for (const GripId& grip : editor().selectedGrips(editor().activeSerial()))
        if (grip.kind == GripKind::middle)
            chosen.push_back(grip.index);
    if (chosen.empty())
        changed.corrections.clear();
    for (const int pair : chosen)
        changed.corrections.erase(pair);
    editor().change(Curve(std::move(changed)), {QT_TRANSLATE_NOOP("Step", "Back to automatic")});
}

} // namespace kriva::ui
