#include "ui/sheets/combined/combined_properties.h"

#include "core/document/limits.h"

namespace kriva::ui {
namespace {

/// The curve with one member set to another value.
template <class Member>
Curve with(const Curve& curve, Member CombinedCurve::*member, double value) {
    CombinedCurve changed = std::get<CombinedCurve>(curve);
    changed.*member = static_cast<Member>(static_cast<int>(value));
    return changed;
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
    finish();
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
    automatic_->setEnabled(!value.corrections.empty() && value.method == CombinedCurve::Method::pairs);
}

void CombinedProperties::dropCorrections() {
    CombinedCurve changed = curve<CombinedCurve>();
    std::vector<int> chosen;
    for (const GripRef& grip : editor().selection())
        if (grip.serial == editor().activeSerial() && grip.id.kind == GripKind::middle)
            chosen.push_back(grip.id.index);
    if (chosen.empty())
        changed.corrections.clear();
    for (const int pair : chosen)
        changed.corrections.erase(pair);
    editor().change(std::move(changed), {QT_TRANSLATE_NOOP("Step", "Back to automatic")});
}

} // namespace kriva::ui
