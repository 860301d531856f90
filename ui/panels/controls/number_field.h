#pragma once

#include <QLineEdit>

namespace kriva::ui {

/// What a number field takes: finite numbers from `lowest` to `highest`.
struct NumberRange {
    double lowest = -1e9;
    double highest = 1e9;
    bool endsExcluded = false;
    bool isWhole = false;

    [[nodiscard]] bool contains(double value) const;
    bool operator==(const NumberRange&) const = default;
};

/// The one field for numbers. It takes decimal point and comma alike, shows the decimal sign of the language and the
/// fewest digits that read back as the same double, and applies nothing but what was typed: showing, focusing and
/// leaving it changes no bit. Enter and leaving apply the typed text once, Escape takes it back, Up, Down and the wheel
/// (of a focused field) step. What it refuses stays in place, marked, with the reason as tooltip and description.
class NumberField : public QLineEdit {
    Q_OBJECT

  public:
    explicit NumberField(QWidget* parent = nullptr);

    void setRange(const NumberRange& range);
    /// How far Up and Down go; 1 unless set.
    void setStep(double step);

    [[nodiscard]] double value() const { return value_; }
    /// Shows `value` without telling anyone. A text being typed stays if the value is the one already held.
    void setValue(double value);

    /// Applies the typed text as Enter does. False if it is refused: then nothing was applied and it stays on show.
    bool commit();

  Q_SIGNALS:
    /// The person applied another number than the one held.
    void valueCommitted(double value);

  protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void retranslateUi();
    void showValue();
    void showVerdict();
    void stepBy(int steps);
    void apply(double value);
    [[nodiscard]] bool isEdited() const { return text() != shown_; }
    [[nodiscard]] bool isAccepted() const;
    [[nodiscard]] QString rangeText() const;

    NumberRange range_;
    double step_ = 1;
    double value_ = 0;
    QString shown_; ///< The text of value_; what differs from it was typed.
    int wheelAngle_ = 0;
};

} // namespace kriva::ui
