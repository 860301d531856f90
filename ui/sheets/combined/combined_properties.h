#pragma once

#include "ui/sheets/properties_panel.h"

#include <QPushButton>

namespace kriva::ui {

/// The method, the degree of the approximation, the basis of the coefficients, and the way back from corrections.
class CombinedProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    CombinedProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;
    void retranslateFields() override;

  private:
    void dropCorrections();

    QComboBox* method_;
    SliderField* degree_;
    QComboBox* basis_;
    QPushButton* automatic_;
};

} // namespace kriva::ui
