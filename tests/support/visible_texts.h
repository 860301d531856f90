#pragma once

#include <QStringList>

class QWidget;

namespace kriva::test {

/// Every text that a person or a screen reader can meet in a widget and all in it: labels, buttons, actions, menus,
/// tabs, titles, entries, cells and headers, tooltips, accessible names. Each line says where the text stands first.
[[nodiscard]] QStringList visibleTexts(QWidget& widget);

} // namespace kriva::test
