#include "ui/tabs/offset/offset_ui.h"

#include "core/curve/limits.h"
#include "core/sheets/offset/offset.h"
#include "ui/tabs/properties/properties_panel.h"

#include <utility>

namespace kriva::ui {
namespace {

/// The curve with one member set to another value.
template <class Member>
Curve with(const Curve& curve, Member OffsetCurve::*member, double value) {
    OffsetCurve changed = std::get<OffsetCurve>(curve);
    changed.*member = static_cast<Member>(value);
    return Curve(std::move(changed));
}

/// How far each polygon is from the one before, and how many there are.
class OffsetProperties : public PropertiesPanel {
  public:
    OffsetProperties(SheetEditor& editor, QWidget* parent)
        : PropertiesPanel(editor, parent)
        , distance_(new SliderField(this))
        , times_(new SliderField(this)) {
        constexpr double kUsualDistance = 5;
        constexpr double kStep = 0.1;
        addRow(QT_TRANSLATE_NOOP("Properties", "Distance"), distance_);
        distance_->setRange({-limits::kNumber, limits::kNumber, false, false});
        distance_->setSlider(-kUsualDistance, kUsualDistance, kStep);
        bind(distance_, [](const Curve& curve, double to) { return with(curve, &OffsetCurve::distance, to); },
             {QT_TRANSLATE_NOOP("Step", "Set the distance")});
        addRow(QT_TRANSLATE_NOOP("Properties", "Polygons"), times_);
        times_->setRange({0, limits::kOffsets, false, true});
        times_->setSlider(0, limits::kOffsets, 1);
        bind(times_, [](const Curve& curve, double to) { return with(curve, &OffsetCurve::times, to); },
             {QT_TRANSLATE_NOOP("Step", "Set the number of polygons")});
        finish();
    }

  protected:
    void showCurve() override {
        distance_->setValue(curve<OffsetCurve>().distance);
        times_->setValue(curve<OffsetCurve>().times);
    }

  private:
    SliderField* distance_;
    SliderField* times_;
};

} // namespace

SheetUi offsetUi() {
    return {.title = QT_TRANSLATE_NOOP("Sheet", "Offset"),
            .makeProperties = [](SheetEditor& editor, QWidget* parent) { return new OffsetProperties(editor, parent); },
            .number = {.raiseText = QT_TRANSLATE_NOOP("SheetActions", "One polygon more"),
                       .lowerText = QT_TRANSLATE_NOOP("SheetActions", "One polygon fewer"),
                       .step = {QT_TRANSLATE_NOOP("Step", "Set the number of polygons")},
                       .value = [](const Curve& curve) { return std::get<OffsetCurve>(curve).times; },
                       .range =
                           [](const Curve&) {
                               return SheetNumber::Range{0, limits::kOffsets};
                           },
                       .with = [](const Curve& curve, int to) { return with(curve, &OffsetCurve::times, to); }},
            .explained = {Role::derivedPolygon}};
}

} // namespace kriva::ui
