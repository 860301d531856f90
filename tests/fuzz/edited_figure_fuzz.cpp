#include "core/io/json/document_json.h"
#include "core/io/open.h"
#include "core/io/svg/drawn_document.h"

#include <cstdint>
#include <cstdlib>

// A figure whose document and whose lines are any bytes: what it draws is a document within the limits of the model, or
// nothing.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view svg(reinterpret_cast<const char*>(data), size);
    const auto inside = kriva::readAnyDocument(svg);
    if (inside.index() != 0)
        return 0;
    const auto drawn = kriva::drawnDocument(svg, std::get<0>(inside));
    if (!drawn)
        return 0;
    const auto back = kriva::readDocument(kriva::writeDocument(*drawn));
    if (back.index() != 0 || !(std::get<0>(back) == *drawn))
        std::abort();
    return 0;
}
