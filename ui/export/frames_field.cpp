#include "ui/export/frames_field.h"

#include "ui/figures/frame_text.h"

#include <utility>

namespace kriva::ui {

FramesField::FramesField(QWidget* parent)
    : CheckedField(parent) {
    showHeld();
}

void FramesField::setFrames(std::vector<FramePlace> frames) {
    frames_ = std::move(frames);
    typed_ = framePlacesText(frames_);
    showHeld();
}

std::vector<FramePlace> FramesField::frames() const {
    return isEdited() ? readFramePlaces(text()).value_or(frames_) : frames_;
}

bool FramesField::accepts(const QString& text) const {
    return readFramePlaces(text).has_value();
}

QString FramesField::refusal() const {
    return tr("At most %n frame(s): stages, such as 0; 5 or 0..10, or values of t, such as t = 0.25; 0.5.", nullptr,
              static_cast<int>(kMostFrames));
}

QString FramesField::heldText() const {
    return typed_;
}

void FramesField::apply(const QString& text) {
    frames_ = *readFramePlaces(text);
    typed_ = text;
}

} // namespace kriva::ui
