#include "ui/tabs/subdivision/subdivision_properties.h"

#include "core/curve/limits.h"
#include "core/sheets/subdivision/subdivision.h"
#include "ui/base/language/number_text.h"
#include "ui/tabs/subdivision/subdivision_actions.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace kriva::ui {
namespace {

constexpr double kStepOfT = 0.01;
constexpr int kStagesOfT = 99; // t = 0.01 to 0.99
constexpr double kLevelsPerSecond = 1;

const SubdivisionCurve& valueOf(const Curve& curve) {
    return std::get<SubdivisionCurve>(curve);
}

} // namespace

SubdivisionProperties::SubdivisionProperties(SheetEditor& editor, QWidget* parent)
    : PropertiesPanel(editor, parent)
    , t_(new SliderField(this))
    , levels_(new SliderField(this))
    , further_(new NumberListField(this))
    , multiplicity_(new NumberField(this))
    , hasBlossom_(new QCheckBox(this))
    , blossom_(new NumberListField(this))
    , playedBox_(new QComboBox(this))
    , player_(new Player(this)) {
    makeRows();
    makeBlossom();
    makePlayer();
    finish();
}

void SubdivisionProperties::makeRows() {
    addRow(QT_TRANSLATE_NOOP("Properties", "Parameter t"), t_);
    t_->setRange({0, 1, true, false});
    t_->setSlider(kStepOfT, 1 - kStepOfT, kStepOfT);
    bind(t_, [](const Curve& curve, double t) { return Curve(withT(valueOf(curve), t)); },
         {QT_TRANSLATE_NOOP("Step", "Set the parameter t")});
    split_ = addButton(QT_TRANSLATE_NOOP("Properties", "Split here"), [this] { splitAtCut(this->editor()); });
    addRow(QT_TRANSLATE_NOOP("Properties", "Levels"), levels_);
    bind(levels_,
         [](const Curve& curve, double levels) { return Curve(withLevels(valueOf(curve), static_cast<int>(levels))); },
         {QT_TRANSLATE_NOOP("Step", "Set the levels")});
    addRow(QT_TRANSLATE_NOOP("Properties", "Further t"), further_);
    further_->setRange(
        {{kFurtherParameters.least, kFurtherParameters.most, true, false}, 0, kFurtherParameters.mostNumbers});
    connect(further_, &NumberListField::numbersCommitted, this, [this](const std::vector<double>& parameters) {
        this->editor().document().setViewNumbers(this->editor().index(), kFurtherParameters, parameters);
    });
    showsCurve_ = addLayerBox("curve");
    showsPieces_ = addLayerBox("pieces");
    setTabOrder(further_, showsCurve_);
    setTabOrder(showsCurve_, showsPieces_);
    setTabOrder(showsPieces_, multiplicity_);
    addRow(QT_TRANSLATE_NOOP("Properties", "Multiplicity of the selected point"), multiplicity_);
    connect(multiplicity_, &NumberField::valueCommitted, this, [this](double times) {
        SubdivisionCurve changed = curve<SubdivisionCurve>();
        for (const int point : editor().selectedPoints())
            changed = withMultiplicity(changed, point, static_cast<int>(times));
        editor().change(Curve(std::move(changed)), {QT_TRANSLATE_NOOP("Step", "Set the multiplicity")});
    });
}

void SubdivisionProperties::makeBlossom() {
    addHeading(QT_TRANSLATE_NOOP("Properties", "Blossom"));
    addWide(hasBlossom_);
    addRow(QT_TRANSLATE_NOOP("Properties", "Arguments"), blossom_);
    connect(hasBlossom_, &QCheckBox::toggled, this, [this](bool on) {
        const auto& value = curve<SubdivisionCurve>();
        std::optional<std::vector<double>> arguments;
        if (on)
            arguments.emplace(controlPointCount(value) - 1, value.t);
        editor().change(Curve(withBlossom(value, std::move(arguments))),
                        on ? StepLabel{QT_TRANSLATE_NOOP("Step", "Show the blossom")}
                           : StepLabel{QT_TRANSLATE_NOOP("Step", "Hide the blossom")});
    });
    connect(blossom_, &NumberListField::numbersCommitted, this, [this](const std::vector<double>& arguments) {
        this->editor().change(Curve(withBlossom(curve<SubdivisionCurve>(), arguments)),
                              {QT_TRANSLATE_NOOP("Step", "Set the blossom")});
    });
}

void SubdivisionProperties::makePlayer() {
    addHeading(QT_TRANSLATE_NOOP("Properties", "Animation"));
    addRow(QT_TRANSLATE_NOOP("Properties", "Runs over"), playedBox_);
    playedBox_->addItems({QString(), QString()});
    addWide(player_);
    connect(playedBox_, &QComboBox::activated, this, [this] {
        player_->pause();
        editor().setStage({});
        showState();
    });
    connect(player_, &Player::stageChanged, this, &SubdivisionProperties::showStage);
    connect(player_, &Player::keepRequested, this, &SubdivisionProperties::keepStage);
}

void SubdivisionProperties::retranslateFields() {
    showsCurve_->setText(tr("Show the curve"));
    showsPieces_->setText(tr("Show the pieces"));
    further_->setToolTip(tr("Shows the de Casteljau scheme at these t as well, like 0.25; 0.75"));
    hasBlossom_->setText(tr("Show the blossom"));
    playedBox_->setItemText(0, tr("Parameter t"));
    playedBox_->setItemText(1, tr("Levels"));
}

void SubdivisionProperties::showCurve() {
    const auto& value = curve<SubdivisionCurve>();
    const int most = mostLevels(std::max<std::size_t>(controlPointCount(value), 2));
    t_->setValue(value.t);
    split_->setEnabled(!isIncomplete(value));
    levels_->setRange({0, static_cast<double>(most), false, true});
    levels_->setSlider(0, most, 1);
    levels_->setValue(value.levels);
    const std::span<const double> further = numbersOf(&editor().sheet().view, kFurtherParameters);
    further_->setNumbers({further.begin(), further.end()});
    showMultiplicity();
    showBlossom();
    const bool overT = played() == Played::t;
    player_->setLast(isIncomplete(value) ? 0 : overT ? kStagesOfT - 1 : most);
    if (!editor().hasStage())
        player_->setStage(overT ? static_cast<int>(std::lround((value.t - kStepOfT) / kStepOfT)) : value.levels);
    player_->setPace(overT ? kStagesPerSecond : kLevelsPerSecond);
    player_->setStageText(stageText());
}

QString SubdivisionProperties::stageText() {
    const SubdivisionCurve onView =
        valueOf(editor().hasStage() ? stageCurve(player_->stage()) : *editor().activeCurve());
    if (played() == Played::t)
        return QStringLiteral("t = %1").arg(formatNumber(onView.t));
    return QStringLiteral("2<sup>%1</sup> = %2").arg(onView.levels).arg(1 << onView.levels);
}

void SubdivisionProperties::showMultiplicity() {
    const std::vector<int> points = editor().selectedPoints();
    const auto& value = curve<SubdivisionCurve>();
    multiplicity_->setEnabled(!points.empty());
    if (!points.empty())
        multiplicity_->setRange({1, static_cast<double>(mostMultiplicity(value, points)), false, true});
    multiplicity_->setValue(points.empty() ? 1 : value.multiplicity[static_cast<std::size_t>(points.front())]);
}

void SubdivisionProperties::showBlossom() {
    const auto& value = curve<SubdivisionCurve>();
    const QSignalBlocker blocker(hasBlossom_);
    hasBlossom_->setEnabled(!isIncomplete(value));
    hasBlossom_->setChecked(value.blossom.has_value());
    blossom_->setEnabled(value.blossom.has_value());
    const std::size_t degree = std::max<std::size_t>(controlPointCount(value), 1) - 1;
    blossom_->setRange({{-limits::kNumber, limits::kNumber}, degree, degree});
    blossom_->setNumbers(value.blossom.value_or(std::vector<double>()));
}

Curve SubdivisionProperties::stageCurve(int stage) const {
    const auto& value = curve<SubdivisionCurve>();
    return Curve(played() == Played::t ? withT(value, stepped(kStepOfT, stage * kStepOfT)) : withLevels(value, stage));
}

void SubdivisionProperties::showStage(int stage) {
    editor().setStage(stageCurve(stage));
}

void SubdivisionProperties::keepStage() {
    player_->pause();
    Curve kept = stageCurve(player_->stage());
    editor().setStage({});
    editor().change(std::move(kept), {QT_TRANSLATE_NOOP("Step", "Keep the stage")});
}

} // namespace kriva::ui
