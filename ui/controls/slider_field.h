#pragma once

#include "ui/controls/number_field.h"

#include <QSlider>
#include <QToolButton>

namespace kriva::ui {

/// A number as a slider with − and + buttons and its value in a field. The slider covers the part of the range that is
/// worth dragging through; the field takes all of it. Showing a value tells nobody.
class SliderField : public QWidget {
    Q_OBJECT
  public:
    explicit SliderField(QWidget* parent = nullptr);

    /// `step` is the way of one key press or click; the slider runs from `lowest` to `highest` in such steps.
    void setSlider(double lowest, double highest, double step);
    void setRange(const NumberRange& range);
    void setValue(double value);
    [[nodiscard]] double value() const { return value_; }
    /// For screen readers, which call the slider and the field by it.
    void setAccessibleTexts(const QString& name, const QString& less, const QString& more);

    [[nodiscard]] QSlider* slider() { return slider_; }
    [[nodiscard]] NumberField* field() { return field_; }

  Q_SIGNALS:
    // A drag of the slider: one dragStarted, any number of valueDragged, one dragEnded.
    void dragStarted();
    void valueDragged(double value);
    void dragEnded();
    /// A key, a click or a turn of the wheel: the next one may follow closely.
    void valueStepped(double value);
    /// A number typed into the field.
    void valueTyped(double value);

  private:
    void showState();
    void takeSlider(int position);
    void stepBy(int steps);
    [[nodiscard]] double valueAt(int position) const;

    QToolButton* less_;
    QSlider* slider_;
    QToolButton* more_;
    NumberField* field_;
    NumberRange range_;
    double lowest_ = 0;
    double step_ = 1;
    double value_ = 0;
};

} // namespace kriva::ui
