#pragma once

#include <QString>

namespace kriva::ui {

/// Text from outside as it may stand on a terminal or in a window: control and bidirectional characters, line ends and
/// halves of characters are written as \uXXXX, so that no name of a file can forge a line or turn one around.
[[nodiscard]] QString printable(const QString& text);

/// Text from outside as it may go into a document: halves of characters, which no UTF-8 has, become U+FFFD.
[[nodiscard]] QString wellFormed(QString text);

/// What printable() makes of a text, for tool tips, which Qt reads as HTML as soon as they look like it: the text comes
/// back as HTML that shows it letter by letter. Empty for an empty one, which has no tool tip.
[[nodiscard]] QString toolTipOf(const QString& text);

/// The same for the title of a window, where Qt replaces "[*]" by the sign of a modified document.
[[nodiscard]] QString windowTitleOf(const QString& text);

/// The same for the text of an action or a tab, where Qt takes a & for the sign of a mnemonic.
[[nodiscard]] QString actionTextOf(const QString& text);

} // namespace kriva::ui
