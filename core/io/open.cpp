#include "core/io/open.h"

#include "core/document/document_json.h"
#include "core/io/svg/svg_reader.h"

namespace kriva {

std::variant<Document, FileError> readAnyDocument(std::string_view bytes) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    std::string_view text = bytes;
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const bool isXml = first != std::string_view::npos && text[first] == '<';
    return isXml ? readDocumentFromSvg(bytes) : readDocument(bytes);
}

} // namespace kriva
