#pragma once

class QWidget;

namespace kriva::ui {

/// Names in the present language what Qt names only once, when it makes it: the buttons of docks and of tab bars.
void renameQtButtons(QWidget& window);

} // namespace kriva::ui
