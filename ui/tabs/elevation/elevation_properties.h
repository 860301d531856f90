#pragma once

#include "ui/controls/player.h"
#include "ui/tabs/properties/properties_panel.h"

namespace kriva::ui {

/// How often the degree is raised, a player over the elevations, and what makes the degree itself higher or lower.
class ElevationProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    ElevationProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;
    void showNoCurve() override;

  private:
    void showReduction();
    void showStage(int times);
    void keepStage();

    SliderField* degree_;
    QPushButton* takePolygon_ = nullptr;
    QPushButton* reduce_ = nullptr;
    QLabel* deviation_;
    Player* player_;
};

} // namespace kriva::ui
