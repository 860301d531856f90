#include "core/io/svg/svg_reader.h"

#include "core/io/json/document_json.h"
#include "core/io/svg/xml/svg_names.h"
#include "core/io/svg/xml/svg_xml.h"

namespace kriva {
namespace {

std::string_view namespaceOf(pugi::xml_node node) {
    const std::string_view prefix = nameOf(node).prefix;
    const std::string declaration = prefix.empty() ? "xmlns" : "xmlns:" + std::string(prefix);
    for (; node; node = node.parent())
        if (const pugi::xml_attribute found = node.attribute(declaration.c_str()))
            return found.value();
    return {};
}

/// The element of ours with that name in the metadata; an empty node where there is none.
pugi::xml_node ownElement(const pugi::xml_node& svg, std::string_view name) {
    // There is one. Each takes a look at all attributes around it: a hostile file has time for no more than these.
    int candidates = 100;
    for (const pugi::xml_node metadata : svg.children()) {
        if (nameOf(metadata).local != "metadata")
            continue;
        for (const pugi::xml_node child : metadata.children())
            if (nameOf(child).local == name && candidates-- > 0 && namespaceOf(child) == kSvgNamespace)
                return child;
    }
    return {};
}

std::string textOf(const pugi::xml_node& element) {
    std::string text;
    for (const pugi::xml_node child : element.children())
        text += child.value();
    return text;
}

} // namespace

std::variant<Document, FileError> readDocumentFromSvg(std::string_view svg) {
    ParsedSvg parsed;
    if (std::optional<FileError> error = openSvg(svg, parsed))
        return std::move(*error);
    const pugi::xml_node element = ownElement(parsed.xml.document_element(), kSvgDocument);
    if (!element)
        return errorOfFile(FileProblem::noDocumentInside);
    std::variant<Document, FileError> document = readDocument(textOf(element));
    // A line of the JSON says nothing about the file; that of its element does.
    if (FileError* error = std::get_if<FileError>(&document)) {
        const FileError inFile = errorAt(error->problem, parsed, element);
        error->line = inFile.line;
        error->column = inFile.column;
        error->isInFigure = true;
    }
    return document;
}

std::optional<DrawnSheet> readDrawnSheetFromSvg(std::string_view svg) {
    ParsedSvg parsed;
    if (openSvg(svg, parsed))
        return {};
    return readDrawnSheet(textOf(ownElement(parsed.xml.document_element(), kSvgDrawing)));
}

} // namespace kriva
