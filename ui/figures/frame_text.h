#pragma once

#include "core/figure/style/figure_options.h"

#include <QString>

#include <optional>
#include <vector>

namespace kriva::ui {

/// The frames that a text names: stages such as "0, 5, 10" or "0..10", or values of t such as "t = 0.25, 0.5". Commas
/// part them, or blanks and semicolons, between which numbers may have a decimal comma. Nothing where it reads
/// otherwise or names more than kMostFrames; an empty text names none.
[[nodiscard]] std::optional<std::vector<FramePlace>> readFramePlaces(const QString& text);

/// The same the other way round, in the present language.
[[nodiscard]] QString framePlacesText(const std::vector<FramePlace>& places);

} // namespace kriva::ui
