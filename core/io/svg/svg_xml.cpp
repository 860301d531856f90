#include "core/io/svg/svg_xml.h"

#include "core/document/limits.h"
#include "core/io/svg/xml_outline.h"

namespace kriva {

std::optional<FileError> openSvg(std::string_view svg, pugi::xml_document& xml) {
    if (svg.size() > limits::kFileBytes)
        return errorOfFile(FileProblem::tooLarge, {static_cast<double>(limits::kFileBytes)});
    if (std::optional<FileError> error = xmlLimitError(svg))
        return error;
    const pugi::xml_parse_result parsed =
        xml.load_buffer(svg.data(), svg.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed)
        return errorAtByte(FileProblem::notXml, svg, static_cast<std::size_t>(parsed.offset));
    return {};
}

QualifiedName nameOf(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos)
        return {"", name};
    return {name.substr(0, colon), name.substr(colon + 1)};
}

} // namespace kriva
