#pragma once

#include "core/io/drawing/drawing.h"

class QPrinter;

namespace kriva::ui {

/// The drawing in the middle of a sheet of paper: in its own size, or as large as fits where it is larger.
void printDrawing(QPrinter& printer, const Drawing& drawing, const TextSource& texts);

} // namespace kriva::ui
