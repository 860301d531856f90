#pragma once

class QWidget;

namespace kriva::ui {

/// Takes what is being typed in a field or a cell of a window, or of a panel that floats over it, as Enter would; the
/// field stays open. What it refuses it says beside itself. To be called before the document is saved, written or given
/// up: neither a shortcut nor a window that is closed takes the focus out of a field.
void commitTyping(const QWidget& window);

} // namespace kriva::ui
