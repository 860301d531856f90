#pragma once

#include "ui/controls/number_field.h"

#include <vector>

namespace kriva::ui {

/// What a field for several numbers takes.
struct NumberListRange {
    NumberRange each;
    std::size_t least = 0; ///< how many
    std::size_t most = 1;

    [[nodiscard]] bool contains(const std::vector<double>& numbers) const;
    /// What is needed, in the present language.
    [[nodiscard]] QString text() const;
};

/// A field for several numbers with semicolons or blanks between them, each typed as in a number field.
class NumberListField : public CheckedField {
    Q_OBJECT
  public:
    explicit NumberListField(QWidget* parent = nullptr);

    void setRange(const NumberListRange& range);
    /// Shows them without telling anyone. A text being typed stays if they are those already held.
    void setNumbers(std::vector<double> numbers);
    [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }

  Q_SIGNALS:
    /// The person applied other numbers than those held.
    void numbersCommitted(const std::vector<double>& numbers);

  protected:
    [[nodiscard]] bool accepts(const QString& text) const override;
    [[nodiscard]] QString refusal() const override { return range_.text(); }
    [[nodiscard]] QString heldText() const override;
    void apply(const QString& text) override;

  private:
    NumberListRange range_;
    std::vector<double> numbers_;
};

} // namespace kriva::ui
