#pragma once

#include "ui/figures/figure_file.h"

#include <QMap>
#include <QStringList>

#include <variant>

namespace kriva::app {

/// The options that only `export` has, by their long names.
struct ExportOptionNames {
    QStringList values; ///< followed by a value
    QStringList flags;
};
[[nodiscard]] ExportOptionNames exportOptionNames();

/// How the figure is to be written, or a sentence about what is wrong with an option. `output` and `format` among the
/// options decide the format.
[[nodiscard]] std::variant<FigureFileOptions, QString> exportOptions(const QMap<QString, QString>& options);

} // namespace kriva::app
