#pragma once

#include "core/figure/plot/plot.h"

#include <QString>

class QWidget;

namespace kriva::ui {

class SheetEditor;

/// Asks for a file and writes the figure on view into it as SVG. `name` is the document's, for the proposed file name.
void exportFigure(const SheetEditor& editor, const QString& name, QWidget* window);

/// The same with plots, one above the other.
void exportPlots(const std::vector<Plot>& plots, QWidget* window);

} // namespace kriva::ui
