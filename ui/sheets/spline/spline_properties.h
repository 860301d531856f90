#pragma once

#include "ui/sheets/properties_panel.h"

#include <QCheckBox>

#include <array>

namespace kriva::ui {

/// The joins in the order of SplineKnot::Join.
inline constexpr std::array kJoinTexts = {
    QT_TRANSLATE_NOOP("Properties", "Automatic"), QT_TRANSLATE_NOOP("Properties", "Symmetric"),
    QT_TRANSLATE_NOOP("Properties", "Smooth"), QT_TRANSLATE_NOOP("Properties", "Corner")};

/// The rule, the degree, whether the chain is closed, the joins of the selected knots, the end derivatives, and the
/// curvature comb.
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
};

} // namespace kriva::ui
