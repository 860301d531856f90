#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

namespace kriva {
struct CurveStyle;
}

namespace kriva::ui {

class LabelledForm;
class NumberField;
class SheetEditor;
struct StepLabel;

/// How the active curve looks: width and dashes of its line, the marks of its points, whether it has labels.
class StyleEditor : public QWidget {
    Q_OBJECT
  public:
    explicit StyleEditor(SheetEditor& editor, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void connectFields();
    void retranslateUi();
    void showState();
    [[nodiscard]] CurveStyle style() const;
    void change(const CurveStyle& style, const StepLabel& label);

    SheetEditor& editor_;
    LabelledForm* form_;
    NumberField* width_;
    QComboBox* dash_;
    QComboBox* marker_;
    QCheckBox* labels_;
    QPushButton* reset_;
};

} // namespace kriva::ui
