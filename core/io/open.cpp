#include "core/io/open.h"

#include "core/io/json/document_json.h"
#include "core/io/svg/svg_reader.h"

namespace kriva {

bool isXml(std::string_view bytes) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (bytes.starts_with(kByteOrderMark))
        bytes.remove_prefix(kByteOrderMark.size());
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

std::variant<Document, FileError> readAnyDocument(std::string_view bytes) {
    return isXml(bytes) ? readDocumentFromSvg(bytes) : readDocument(bytes);
}

} // namespace kriva
