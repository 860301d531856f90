#pragma once

#include "ui/controls/player.h"
#include "ui/tabs/properties/properties_panel.h"

#include <QPushButton>

namespace kriva::ui {

/// The method, the degree of the approximation, the basis of the coefficients, the way back from corrections, and a
/// player over the stages of the algorithm.
class CombinedProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    CombinedProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;
    void retranslateFields() override;

  private:
    void dropCorrections();
    void makePlayer();
    void showStage(int stage);
    [[nodiscard]] static QString stageName(int stage);

    QComboBox* method_;
    SliderField* degree_;
    QComboBox* basis_;
    QPushButton* automatic_;
    Player* player_ = nullptr;
};

} // namespace kriva::ui
