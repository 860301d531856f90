#include "ui/tabs/spline/spline_properties.h"

#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/joins.h"
#include "ui/base/look/plain_label.h"
#include "ui/panels/result_text.h"
#include "ui/tabs/spline/built_in_drawing.h"
#include "ui/tabs/spline/spline_actions.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace kriva::ui {
namespace {

constexpr double kStepOfComb = 0.1;
constexpr int kUsualPolylinePoints = 32; // more can hardly be told from the curve
constexpr double kUsualCombs = 5;        // times the automatic scale: longer teeth leave the canvas

/// In the order of kRules, which is that of the values.
constexpr std::array kRuleTexts = {
    QT_TRANSLATE_NOOP("Properties", "Mirror"), QT_TRANSLATE_NOOP("Properties", "Natural"),
    QT_TRANSLATE_NOOP("Properties", "Clamped"), QT_TRANSLATE_NOOP("Properties", "Catmull–Rom")};
static_assert(kRuleTexts.size() == kRules.size());

const SplineCurve& valueOf(const Curve& curve) {
    return std::get<SplineCurve>(curve);
}

} // namespace

SplineProperties::SplineProperties(SheetEditor& editor, QWidget* parent)
    : PropertiesPanel(editor, parent)
    , degree_(new SliderField(this))
    , closed_(new QCheckBox(this))
    , comparison_(editor.workers(), [this] { return comparison(); }) {
    rule_ =
        addChoice(QT_TRANSLATE_NOOP("Properties", "Rule"), {kRuleTexts.begin(), kRuleTexts.end()},
                  [](const Curve& curve, double rule) {
                      return Curve(withRule(valueOf(curve), static_cast<SplineCurve::Rule>(static_cast<int>(rule))));
                  },
                  {QT_TRANSLATE_NOOP("Step", "Set the rule")});
    addRow(QT_TRANSLATE_NOOP("Properties", "Degree"), degree_);
    degree_->setRange({limits::kSplineDegreeLow, limits::kSplineDegreeHigh, false, true});
    degree_->setSlider(limits::kSplineDegreeLow, limits::kSplineDegreeHigh, 1);
    bind(degree_,
         [](const Curve& curve, double degree) { return Curve(withDegree(valueOf(curve), static_cast<int>(degree))); },
         {QT_TRANSLATE_NOOP("Step", "Set the degree")});
    addWide(closed_);
    connect(closed_, &QCheckBox::toggled, this, [this](bool on) {
        SheetEditor& target = this->editor();
        target.change(Curve(withClosed(curve<SplineCurve>(), on)),
                      on ? StepLabel{QT_TRANSLATE_NOOP("Step", "Close the curve")}
                         : StepLabel{QT_TRANSLATE_NOOP("Step", "Open the curve")});
    });
    addHeading(QT_TRANSLATE_NOOP("Properties", "Selected knots"));
    join_ = addChoice(QT_TRANSLATE_NOOP("Properties", "Join"), {kJoinTexts.begin(), kJoinTexts.end()},
                      [this](const Curve& curve, double join) {
                          return Curve(withJoin(valueOf(curve), chosenKnots(this->editor()),
                                                static_cast<SplineKnot::Join>(static_cast<int>(join))));
                      },
                      {QT_TRANSLATE_NOOP("Step", "Set the join")});
    addHeading(QT_TRANSLATE_NOOP("Properties", "End derivatives"));
    start_ = addDerivative(QT_TRANSLATE_NOOP("Properties", "Start"), End::start);
    end_ = addDerivative(QT_TRANSLATE_NOOP("Properties", "End"), End::end);
    addComb();
    addComparison();
    finish();
}

void SplineProperties::addComb() {
    addHeading(QT_TRANSLATE_NOOP("Properties", "Curvature comb"));
    showsComb_ = addLayerBox("curvature-comb");
    combScale_ = new SliderField(this);
    addRow(QT_TRANSLATE_NOOP("Properties", "Scale of the comb"), combScale_);
    combScale_->setRange({kCombScale.least, kCombScale.most, false, false});
    combScale_->setSlider(kStepOfComb, kUsualCombs, kStepOfComb);
    bindView(combScale_,
             [this](double scale) { editor().document().setViewNumbers(editor().index(), kCombScale, {scale}); });
}

void SplineProperties::addComparison() {
    addHeading(QT_TRANSLATE_NOOP("Properties", "Comparison with the built-in drawing"));
    showsPolyline_ = addLayerBox("polyline");
    polylinePoints_ = new SliderField(this);
    addRow(QT_TRANSLATE_NOOP("Properties", "Points per segment"), polylinePoints_);
    polylinePoints_->setRange({kPolylinePoints.least, kPolylinePoints.most, false, true});
    polylinePoints_->setSlider(kPolylinePoints.least, kUsualPolylinePoints, 1);
    bindView(polylinePoints_, [this](double points) {
        editor().document().setViewNumbers(editor().index(), kPolylinePoints, {points});
    });
    deviation_ = new PlainLabel(this);
    addRow(QT_TRANSLATE_NOOP("Properties", "Largest deviation"), deviation_);
    deviation_->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

CoalescingWorker::Work SplineProperties::comparison() {
    const Curve* curve = editor().shown(editor().activeSerial());
    const int points = static_cast<int>(numberOf(&editor().sheet().view, kPolylinePoints));
    return [this, points, value = curve ? std::get<SplineCurve>(*curve) : SplineCurve()](
               WorkBudget& budget) -> CoalescingWorker::Take {
        return [this, deviation = deviationFromBuiltIn(value, points, budget)] {
            if (showsPolyline_->isChecked() && deviation)
                deviation_->setText(valueText(*deviation, kDeviationDigits));
        };
    };
}

SplineProperties::DerivativeRow SplineProperties::addDerivative(const char* label, End end) {
    auto* fields = new QWidget(this);
    const DerivativeRow row{new QCheckBox(fields), new NumberField(fields), new NumberField(fields)};
    auto* layout = new QHBoxLayout(fields);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(row.isGiven);
    layout->addWidget(row.x, 1);
    layout->addWidget(row.y, 1);
    addRow(label, fields);
    connect(row.isGiven, &QCheckBox::toggled, this, [this, row, end](bool on) {
        setDerivative(end, on ? std::optional(Vector{row.x->value(), row.y->value()}) : std::nullopt);
    });
    connect(row.x, &NumberField::valueCommitted, this, [this, row, end](double x) {
        setDerivative(end, Vector{x, row.y->value()});
    });
    connect(row.y, &NumberField::valueCommitted, this, [this, row, end](double y) {
        setDerivative(end, Vector{row.x->value(), y});
    });
    return row;
}

std::optional<Vector> SplineProperties::givenDerivative(End end) const {
    const auto& value = curve<SplineCurve>();
    return end == End::start ? value.startDerivative : value.endDerivative;
}

void SplineProperties::setDerivative(End end, std::optional<Vector> derivative) {
    const auto& value = curve<SplineCurve>();
    const bool isStart = end == End::start;
    editor().change(Curve(withEndDerivatives(value, isStart ? derivative : value.startDerivative,
                                             isStart ? value.endDerivative : derivative)),
                    isStart ? StepLabel{QT_TRANSLATE_NOOP("Step", "Change the start derivative")}
                            : StepLabel{QT_TRANSLATE_NOOP("Step", "Change the end derivative")});
}

void SplineProperties::retranslateFields() {
    closed_->setText(tr("Closed"));
    showsComb_->setText(tr("Show the comb"));
    showsPolyline_->setText(tr("Show the polyline"));
    for (const DerivativeRow& row : {start_, end_}) {
        row.isGiven->setToolTip(tr("Given here; otherwise that of the natural spline"));
        row.isGiven->setAccessibleName(tr("Given"));
        row.x->setAccessibleName(QStringLiteral("x"));
        row.y->setAccessibleName(QStringLiteral("y"));
    }
}

void SplineProperties::showCurve() {
    const auto& value = curve<SplineCurve>();
    rule_->setCurrentIndex(static_cast<int>(value.rule));
    rule_->setEnabled(value.degree > 2); // parabolas follow no rule
    degree_->setValue(value.degree);
    const QSignalBlocker blocker(closed_);
    closed_->setChecked(value.closed);
    const std::vector<int> knots = chosenKnots(editor());
    join_->setEnabled(!knots.empty() && value.degree > 2);
    if (!knots.empty())
        join_->setCurrentIndex(static_cast<int>(value.knots[static_cast<std::size_t>(knots.front())].join));
    combScale_->setValue(numberOf(&editor().sheet().view, kCombScale));
    combScale_->setEnabled(showsComb_->isChecked());
    showDerivative(start_, End::start);
    showDerivative(end_, End::end);
    showComparison();
}

void SplineProperties::showComparison() {
    const bool isShown = showsPolyline_->isChecked();
    polylinePoints_->setValue(numberOf(&editor().sheet().view, kPolylinePoints));
    polylinePoints_->setEnabled(isShown);
    if (isShown)
        comparison_.doSoon();
    else
        deviation_->setText(QStringLiteral("–"));
}

void SplineProperties::showDerivative(const DerivativeRow& row, End end) {
    const auto& value = curve<SplineCurve>();
    const bool isUsed = value.rule == SplineCurve::Rule::clamped && !value.closed && value.degree > 2;
    const std::optional<Vector> given = givenDerivative(end);
    const EndDerivatives present = isUsed ? endDerivatives(value, knotHandles(value)) : EndDerivatives{};
    const Vector shown = given.value_or((end == End::start ? present.start : present.end).value_or(Vector{}));
    const QSignalBlocker blocker(row.isGiven);
    row.isGiven->setChecked(given.has_value());
    row.isGiven->setEnabled(isUsed);
    row.x->setEnabled(isUsed);
    row.y->setEnabled(isUsed);
    row.x->setValue(shown.x);
    row.y->setValue(shown.y);
}

} // namespace kriva::ui
