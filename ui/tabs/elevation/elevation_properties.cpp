#include "ui/tabs/elevation/elevation_properties.h"

#include "core/geometry/tolerance.h"
#include "core/sheets/elevation/elevation.h"
#include "ui/base/look/plain_label.h"
#include "ui/panels/result_text.h"
#include "ui/tabs/elevation/elevation_actions.h"

#include <algorithm>

namespace kriva::ui {
namespace {

/// As far as one looks at first: the 97 elevations after which the polygon of a cubic can hardly be told from it.
constexpr int kUsualElevations = 97;

/// The largest number of elevations that the slider and the player run through.
int shownElevations(const ElevationCurve& curve) {
    return std::max(kUsualElevations, curve.times);
}

Curve withTimes(const Curve& curve, int times) {
    ElevationCurve changed = std::get<ElevationCurve>(curve);
    changed.times = times;
    return Curve(std::move(changed));
}

} // namespace

ElevationProperties::ElevationProperties(SheetEditor& editor, QWidget* parent)
    : PropertiesPanel(editor, parent)
    , degree_(new SliderField(this))
    , deviation_(new PlainLabel(this))
    , player_(new Player(this)) {
    addRow(QT_TRANSLATE_NOOP("Properties", "Degree"), degree_);
    bind(degree_,
         [](const Curve& curve, double degree) {
             return withTimes(curve, static_cast<int>(degree) - *polynomialDegree(curve));
         },
         {QT_TRANSLATE_NOOP("Step", "Raise the degree")});
    connect(degree_, &SliderField::dragEnded, this, &ElevationProperties::showState);
    takePolygon_ = addButton(QT_TRANSLATE_NOOP("Properties", "Make this the control polygon"),
                             [this] { takeElevatedPolygon(this->editor()); });
    reduce_ = addButton(QT_TRANSLATE_NOOP("Properties", "Reduce the degree by one"),
                        [this] { reduceDegree(this->editor()); });
    addWide(deviation_);
    deviation_->setWordWrap(true);
    addHeading(QT_TRANSLATE_NOOP("Properties", "Animation"));
    addWide(player_);
    connect(player_, &Player::stageChanged, this, &ElevationProperties::showStage);
    connect(player_, &Player::keepRequested, this, &ElevationProperties::keepStage);
    finish();
}

void ElevationProperties::showCurve() {
    const auto& value = curve<ElevationCurve>();
    setEnabled(!isIncomplete(value));
    takePolygon_->setEnabled(canTakeElevatedPolygon(editor()));
    showReduction();
    if (isIncomplete(value))
        return;
    const int degree = *polynomialDegree(value);
    degree_->setRange({static_cast<double>(degree), static_cast<double>(degree + limits::kElevations), false, true});
    if (!degree_->slider()->isSliderDown()) // the way of a handle that is held keeps its length
        degree_->setSlider(degree, degree + shownElevations(value), 1);
    degree_->setValue(degree + value.times);
    player_->setLast(shownElevations(value));
    if (!editor().hasStage())
        player_->setStage(value.times);
    player_->setStageText(QStringLiteral("N = %1").arg(degree + player_->stage()));
}

void ElevationProperties::showNoCurve() {
    deviation_->clear();
}

void ElevationProperties::showReduction() {
    const std::optional<Refitted<ElevationCurve>> reduced = withDegreeReduced(curve<ElevationCurve>());
    reduce_->setEnabled(reduced.has_value());
    if (!reduced)
        deviation_->setText(tr("The degree cannot fall any more"));
    else if (*reduced->deviation <= kRoundingPart * diagonal(boxOf(curve<ElevationCurve>().points)))
        deviation_->setText(tr("The curve then stays as it is"));
    else
        deviation_->setText(
            tr("The curve then moves by at most %1").arg(valueText(*reduced->deviation, kDeviationDigits)));
}

void ElevationProperties::showStage(int times) {
    editor().setStage(withTimes(*editor().activeCurve(), times));
}

void ElevationProperties::keepStage() {
    player_->pause();
    Curve kept = withTimes(*editor().activeCurve(), player_->stage());
    editor().setStage({});
    editor().change(std::move(kept), {QT_TRANSLATE_NOOP("Step", "Keep the stage")});
}

} // namespace kriva::ui
