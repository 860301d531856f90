#pragma once

#include "core/figure/caption.h"

#include <functional>
#include <string>

namespace kriva {

/// Through which the writers of figures get words and numbers in a person's language. Texts are UTF-8.
struct TextSource {
    std::function<std::string(Caption)> translate;
    std::function<std::string(double value, int decimals)> number;
    std::string language; ///< "en", as in xml:lang
};

} // namespace kriva
