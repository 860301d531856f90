#include "core/io/svg/xml/svg_xml.h"

#include "core/curve/limits.h"
#include "core/io/svg/xml/xml_characters.h"
#include "core/io/svg/xml/xml_outline.h"

namespace kriva {
namespace {

FileError errorAtParsedByte(FileProblem problem, const ParsedSvg& parsed, std::ptrdiff_t offset) {
    const auto byte = static_cast<std::size_t>(offset);
    return errorAtByte(problem, parsed.text, parsed.repaired.empty() ? byte : byteBeforeRepair(parsed.text, byte));
}

} // namespace

std::optional<FileError> openSvg(std::string_view svg, ParsedSvg& parsed) {
    if (svg.size() > limits::kFileBytes)
        return errorOfFile(FileProblem::tooLarge, {static_cast<double>(limits::kFileBytes)});
    if (std::optional<FileError> error = xmlError(svg))
        return error;
    parsed.text = svg;
    if (hasBrokenCharacters(svg))
        parsed.repaired = withoutBrokenCharacters(svg);
    const std::string_view read = parsed.repaired.empty() ? svg : parsed.repaired;
    const pugi::xml_parse_result result =
        parsed.xml.load_buffer(read.data(), read.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result)
        return errorAtParsedByte(FileProblem::notXml, parsed, result.offset);
    return {};
}

FileError errorAt(FileProblem problem, const ParsedSvg& parsed, const pugi::xml_node& element) {
    return errorAtParsedByte(problem, parsed, element.offset_debug());
}

QualifiedName nameOf(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos)
        return {"", name};
    return {name.substr(0, colon), name.substr(colon + 1)};
}

} // namespace kriva
