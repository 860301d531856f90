#include "ui/controls/kept_choice.h"

#include "ui/controls/focused_wheel.h"

#include <QSignalBlocker>

#include <algorithm>

namespace kriva::ui {

KeptChoice::KeptChoice(QWidget* parent)
    : QComboBox(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon); // a long name must not widen the panel
    takeWheelWithFocusOnly(*this);
}

void KeptChoice::setNames(const QStringList& names) {
    const QSignalBlocker blocker(this);
    const int chosen = std::max(0, currentIndex());
    clear();
    addItems(names);
    setCurrentIndex(std::min(chosen, count() - 1));
    setEnabled(!names.empty());
}

} // namespace kriva::ui
