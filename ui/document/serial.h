#pragma once

#include <QtGlobal>

namespace kriva::ui {

/// Names a curve for as long as its document is open: given by the open document, never reused, and brought back when
/// a deletion is undone.
using Serial = quint64;

} // namespace kriva::ui
