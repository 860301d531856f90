#include "core/io/svg/imported.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are refused or are paths within the limits of the model, of which every sheet makes curves or says why not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = kriva::readSvgPaths({reinterpret_cast<const char*>(data), size});
    if (const auto* paths = std::get_if<std::vector<kriva::ImportedPath>>(&read))
        for (kriva::SheetIndex sheet = 0; sheet < kriva::kSheetCount; ++sheet) {
            const auto curves = kriva::importedCurves(*paths, sheet);
            if (curves.index() == 0 && std::get<0>(curves).size() != paths->size())
                std::abort();
        }
    return 0;
}
