#pragma once

#include "ui/controls/slider_field.h"
#include "ui/editing/sheet_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <functional>

namespace kriva::ui {

/// What the Properties panels of all tabs share: rows with labels in the present language, fields that set one number
/// of the active curve, and one place that shows its state.
class PropertiesPanel : public QWidget {
    Q_OBJECT
  public:
    PropertiesPanel(SheetEditor& editor, QWidget* parent);

  protected:
    using Change = std::function<Curve(const Curve&, double)>;

    /// Shows the active curve; nothing else may set a field. Not called while the sheet is empty: all is disabled then.
    virtual void showCurve() = 0;
    /// Clears what a disabled panel should not say.
    virtual void showNoCurve() {}
    /// Gives every text of the panel that no row has.
    virtual void retranslateFields() {}

    /// `label` is marked with QT_TRANSLATE_NOOP("Properties", ...).
    void addRow(const char* label, QWidget* field);
    void addWide(QWidget* widget);
    void addHeading(const char* label);
    /// Drags of the slider become one step, keys that follow closely become one, and so does a typed number.
    void bind(SliderField* field, const Change& change, const StepLabel& step);
    /// The same for a number of the view, which is never undone: every value is set at once.
    void bindView(SliderField* field, const std::function<void(double)>& set);
    /// A box that shows and hides a layer of the sheet, below all rows so far.
    QCheckBox* addLayerBox(std::string_view layer);
    /// A button as wide as the panel; `label` likewise.
    QPushButton* addButton(const char* label, const std::function<void()>& run);
    /// A box whose entries stand for the values of an enumeration, in its order.
    QComboBox* addChoice(const char* label, std::vector<const char*> entries, const Change& change,
                         const StepLabel& step);
    /// Ends a constructor: gives texts and shows the state.
    void finish();
    void showState();

    [[nodiscard]] SheetEditor& editor() { return editor_; }
    template <class C>
    [[nodiscard]] const C& curve() const {
        return std::get<C>(*editor_.activeCurve());
    }

    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        QLabel* label;
        const char* text;
        QWidget* field; ///< null for headings
    };
    struct Choice {
        QComboBox* box;
        std::vector<const char*> entries;
    };
    struct Button {
        QPushButton* button;
        const char* text;
    };
    struct LayerBox {
        QCheckBox* box;
        std::string_view layer;
    };
    void retranslateUi();
    void showLayerBoxes();

    SheetEditor& editor_;
    QFormLayout* layout_;
    std::vector<Row> rows_;
    std::vector<Choice> choices_;
    std::vector<Button> buttons_;
    std::vector<LayerBox> layerBoxes_;
};

} // namespace kriva::ui
