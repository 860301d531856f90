#pragma once

#include "core/curve/file_error.h"
#include "core/curve/results.h"
#include "core/figure/figure.h"

#include <vector>

namespace kriva {

/// What the curves of a sheet have with each other and no single one has: rows of numbers, and a figure above theirs.
struct Relations {
    std::vector<Result> results;
    Figure figure;
    std::optional<FileError> refusal; ///< why there are no more: reports and figures of files are refused then
};

} // namespace kriva
