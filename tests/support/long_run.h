#pragma once

#include <cstdlib>

namespace kriva::test {

/// Whether tests/run --long goes on, which has time for what takes long.
[[nodiscard]] inline bool isLongRun() {
    return std::getenv("KRIVA_LONG_TESTS") != nullptr;
}

} // namespace kriva::test
