#pragma once

#include "core/figure/style/figure_options.h"

#include <QStringList>

#include <variant>

class QCommandLineParser;

namespace kriva::app {

/// The options that only `export` has, by their long names, with an equals sign where a value follows.
[[nodiscard]] QStringList exportOptionNames();

/// How the figure is to be written, or a sentence about what is wrong with an option. `output` and `format` among the
/// options decide the format.
[[nodiscard]] std::variant<FigureFileOptions, QString> exportOptions(const QCommandLineParser& options);

} // namespace kriva::app
