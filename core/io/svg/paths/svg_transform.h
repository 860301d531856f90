#pragma once

#include "core/geometry/affine.h"

#include <optional>
#include <string_view>

namespace kriva {

/// What a `transform` attribute says: a list of matrix, translate, scale, rotate, skewX and skewY, of which the last is
/// done first. Nothing where it breaks the grammar of SVG 1.1 (7.6). Linear.
[[nodiscard]] std::optional<Affine> readTransform(std::string_view text);

} // namespace kriva
