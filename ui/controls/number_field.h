#pragma once

#include "ui/controls/checked_field.h"

namespace kriva::ui {

/// What a number field takes: finite numbers from `lowest` to `highest`.
struct NumberRange {
    double lowest = -1e9;
    double highest = 1e9;
    bool endsExcluded = false;
    bool isWhole = false;

    [[nodiscard]] bool contains(double value) const;
    /// What is needed, in the present language.
    [[nodiscard]] QString text() const;
    bool operator==(const NumberRange&) const = default;
};

/// The one field for numbers. It takes decimal point and comma alike, shows the decimal sign of the language and the
/// fewest digits that read back as the same double, and applies nothing but what was typed: showing, focusing and
/// leaving it changes no bit. Up, Down and the wheel (of a focused field) step.
class NumberField : public CheckedField {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);

    void setRange(const NumberRange& range);
    /// How far Up and Down go; 1 unless set.
    void setStep(double step);

    [[nodiscard]] double value() const { return value_; }
    /// Shows `value` without telling anyone; an empty text where it is no number (NaN), which nobody can type. A text
    /// being typed stays if the value is the one already held.
    void setValue(double value);

  Q_SIGNALS:
    /// The person applied another number than the one held.
    void valueCommitted(double value);

  protected:
    [[nodiscard]] bool accepts(const QString& text) const override;
    [[nodiscard]] QString refusal() const override { return range_.text(); }
    [[nodiscard]] QString heldText() const override;
    void apply(const QString& text) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void stepBy(int steps);
    void take(double value);

    NumberRange range_;
    double step_ = 1;
    double value_ = 0;
    int wheelAngle_ = 0;
};

} // namespace kriva::ui
