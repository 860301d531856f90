#include "core/curve/limits.h"
#include "core/io/svg/paths/path_reader.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are refused or are paths whose pieces have their points and join end to end.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = kriva::readPathData({reinterpret_cast<const char*>(data), size});
    if (const auto* paths = std::get_if<std::vector<kriva::Path>>(&read))
        for (const kriva::Path& path : *paths) {
            std::size_t points = 1;
            for (const int degree : path.degrees)
                points += static_cast<std::size_t>(degree);
            const bool isClosed = path.isClosed && path.points.front() != path.points.back();
            if (path.degrees.empty() || path.points.size() != points || isClosed)
                std::abort();
        }
    return 0;
}
