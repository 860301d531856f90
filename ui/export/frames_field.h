#pragma once

#include "core/figure/style/figure_options.h"
#include "ui/controls/checked_field.h"

#include <vector>

namespace kriva::ui {

/// A field for the frames of a figure: "0; 5; 10", "0..10" or "t = 0.25; 0.5".
class FramesField : public CheckedField {
    Q_OBJECT
  public:
    explicit FramesField(QWidget* parent = nullptr);

    void setFrames(std::vector<FramePlace> frames);
    /// Those that are typed; while they are refused, those that held before.
    [[nodiscard]] std::vector<FramePlace> frames() const;

  protected:
    [[nodiscard]] bool accepts(const QString& text) const override;
    [[nodiscard]] QString refusal() const override;
    [[nodiscard]] QString heldText() const override;
    void apply(const QString& text) override;

  private:
    std::vector<FramePlace> frames_;
    QString typed_; ///< as a person said it last: "0..10" is not spelt out
};

} // namespace kriva::ui
