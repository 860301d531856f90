#include "core/io/json/document_json.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are refused or are a document; a document that was read is written so that it reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto read = kriva::readDocument({reinterpret_cast<const char*>(data), size});
    if (const auto* document = std::get_if<kriva::Document>(&read)) {
        const auto again = kriva::readDocument(kriva::writeDocument(*document));
        if (!std::holds_alternative<kriva::Document>(again) || std::get<kriva::Document>(again) != *document)
            std::abort();
    }
    return 0;
}
