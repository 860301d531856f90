#pragma once

#include "ui/editing/results/coalescing_worker.h"
#include "ui/tabs/properties/properties_panel.h"

#include <QCheckBox>

#include <array>

namespace kriva::ui {

/// The joins in the order of SplineKnot::Join.
inline constexpr std::array kJoinTexts = {
    QT_TRANSLATE_NOOP("Properties", "Automatic"), QT_TRANSLATE_NOOP("Properties", "Symmetric"),
    QT_TRANSLATE_NOOP("Properties", "Smooth"), QT_TRANSLATE_NOOP("Properties", "Corner")};

/// The rule, the degree, whether the chain is closed, the joins of the selected knots, the end derivatives, the
/// curvature comb, and how far Qt's own drawing and a polyline through points of the curve are apart.
class SplineProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    SplineProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;
    void retranslateFields() override;

  private:
    /// One end derivative: whether it is given, and its coordinates.
    struct DerivativeRow {
        QCheckBox* isGiven;
        NumberField* x;
        NumberField* y;
    };
    enum class End { start, end };

    DerivativeRow addDerivative(const char* label, End end);
    void addComb();
    void addComparison();
    /// What is worked out of the curve as it is now.
    [[nodiscard]] CoalescingWorker::Work comparison();
    void showComparison();
    void showDerivative(const DerivativeRow& row, End end);
    void setDerivative(End end, std::optional<Vector> derivative);
    [[nodiscard]] std::optional<Vector> givenDerivative(End end) const;

    QComboBox* rule_;
    SliderField* degree_;
    QCheckBox* closed_;
    QComboBox* join_;
    DerivativeRow start_;
    DerivativeRow end_;
    QCheckBox* showsComb_ = nullptr;
    SliderField* combScale_ = nullptr;
    QCheckBox* showsPolyline_ = nullptr;
    SliderField* polylinePoints_ = nullptr;
    QLabel* deviation_ = nullptr;
    CoalescingWorker comparison_;
};

} // namespace kriva::ui
