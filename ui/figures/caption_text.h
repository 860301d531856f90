#pragma once

#include "core/figure/caption.h"
#include "core/figure/text_source.h"

#include <QString>

namespace kriva::ui {

/// The words of a caption in the present language.
[[nodiscard]] QString captionText(Caption caption);

/// Captions and numbers in the present language, for core's writers and the canvas.
[[nodiscard]] TextSource textSource();

} // namespace kriva::ui
