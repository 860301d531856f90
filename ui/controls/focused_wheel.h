#pragma once

class QWidget;

namespace kriva::ui {

/// Lets a slider or a choice take the wheel only while it has the focus: else whoever scrolls a panel would change what
/// happens to come under the pointer. The panel scrolls then. Number fields do so by themselves; all that is neither
/// keeps the wheel as it was.
void takeWheelWithFocusOnly(QWidget& field);

} // namespace kriva::ui
