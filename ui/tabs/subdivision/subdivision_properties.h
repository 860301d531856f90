#pragma once

#include "ui/controls/number_list_field.h"
#include "ui/controls/player.h"
#include "ui/tabs/properties/properties_panel.h"

#include <QCheckBox>

namespace kriva::ui {

/// Where the curve is cut and how often, the cut that makes two curves of it, at which further t its scheme is shown,
/// whether the curve is shown, how often the selected points stand, the blossom's arguments, and a player over t or
/// over the levels.
class SubdivisionProperties : public PropertiesPanel {
    Q_OBJECT
  public:
    SubdivisionProperties(SheetEditor& editor, QWidget* parent);

  protected:
    void showCurve() override;
    void retranslateFields() override;

  private:
    enum class Played { t, levels };

    void makeRows();
    void makeBlossom();
    void makePlayer();
    void showMultiplicity();
    void showBlossom();
    void showStage(int stage);
    void keepStage();
    [[nodiscard]] Curve stageCurve(int stage) const;
    /// Of the stage on view.
    [[nodiscard]] QString stageText();
    [[nodiscard]] Played played() const { return static_cast<Played>(playedBox_->currentIndex()); }

    SliderField* t_;
    QPushButton* split_ = nullptr;
    SliderField* levels_;
    NumberListField* further_;
    QCheckBox* showsCurve_ = nullptr;
    QCheckBox* showsPieces_ = nullptr;
    NumberField* multiplicity_;
    QCheckBox* hasBlossom_;
    NumberListField* blossom_;
    QComboBox* playedBox_;
    Player* player_;
};

} // namespace kriva::ui
