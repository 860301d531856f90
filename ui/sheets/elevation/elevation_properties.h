#pragma once

#include "ui/panels/controls/player.h"
#include "ui/sheets/properties_panel.h"

namespace kriva::ui {

/// How often the degree is raised, and a player over the elevations.
class ElevationProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    ElevationProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;

  private:
    void showStage(int times);
    void keepStage();

    SliderField* degree_;
    Player* player_;
};

} // namespace kriva::ui
