#include "core/io/svg/paths/svg_paths.h"

#include "core/document/limits.h"
#include "core/io/svg/paths/path_reader.h"
#include "core/io/svg/paths/svg_shapes.h"
#include "core/io/svg/paths/svg_transform.h"
#include "core/io/svg/paths/svg_view_box.h"
#include "core/io/svg/svg_names.h"
#include "core/io/svg/svg_xml.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace kriva {
namespace {

/// Names of elements that are drawn where another one refers to them, or that draw no lines.
bool isDrawnElsewhere(std::string_view name) {
    constexpr std::array<std::string_view, 8> kNames{"defs",   "symbol",  "clipPath", "mask",
                                                     "marker", "pattern", "metadata", "glyph"};
    return std::ranges::find(kNames, name) != kNames.end();
}

bool isDisplayed(const pugi::xml_node& element) {
    if (element.attribute("display").value() == std::string_view("none"))
        return false;
    std::string style = element.attribute("style").value();
    std::erase_if(style, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
    return style.find("display:none") == std::string::npos;
}

class SvgPaths {
  public:
    SvgPaths(std::string_view svg, const pugi::xml_node& root)
        : svg_(svg)
        , root_(root) {}

    /// All that is drawn, or the curves of a figure of Kriva's own.
    [[nodiscard]] std::variant<std::vector<ImportedPath>, FileError> read() &&;
    /// The curves of a figure of Kriva's own alone.
    [[nodiscard]] std::variant<std::vector<ImportedPath>, FileError> readOwn() &&;

  private:
    /// What elements inherit.
    struct Place {
        Affine map;
        SvgViewport viewport;
        std::string name;
        int uses = 0; ///< around it
    };

    /// Where the outermost elements are; nothing where the page's size cannot be read.
    std::optional<Place> outermost();
    [[nodiscard]] pugi::xml_node ownLayer() const {
        return root_.find_child_by_attribute("id", std::string(kSvgLayerId).append(kCurveLayer).c_str());
    }

    // Each of these gives false where there is a fault.
    bool children(const pugi::xml_node& parent, const Place& place);
    bool element(const pugi::xml_node& element, Place place);
    bool use(const pugi::xml_node& element, Place place);
    /// A nested `svg` or a `symbol`, in a viewport of this size where one is given.
    bool nested(const pugi::xml_node& element, Place place, std::optional<SvgViewport> size);
    bool shape(const pugi::xml_node& element, const Place& place);
    bool refuse(const pugi::xml_node& element, std::string_view attribute);
    bool refuse(FileError error) {
        fault_ = std::move(error);
        return false;
    }

    [[nodiscard]] pugi::xml_node named(std::string_view id);
    /// A length of an element, `otherwise` where it is missing; nothing where it cannot be read, which is told.
    std::optional<double> length(const pugi::xml_node& element, const char* name, double whole, double otherwise);
    /// Its x, y, width and height, by default those of the viewport around it; nothing where one cannot be read.
    std::optional<ViewBox> placeOf(const pugi::xml_node& element, const SvgViewport& around);
    /// Nothing where there is none; false where it cannot be read.
    bool viewBoxOf(const pugi::xml_node& element, std::optional<ViewBox>& box);

    std::string_view svg_;
    const pugi::xml_node& root_;
    std::vector<ImportedPath> paths_;
    std::optional<FileError> fault_;
    std::unordered_map<std::string_view, pugi::xml_node> ids_; ///< of all elements, made when one is asked for
    int visited_ = 0;
    std::size_t points_ = 0;
};

std::optional<SvgPaths::Place> SvgPaths::outermost() {
    constexpr SvgViewport kUsual{300, 150}; // of a page that says nothing
    Place place;
    place.map = scaling(1, -1);
    std::optional<ViewBox> box;
    if (!viewBoxOf(root_, box))
        return {};
    if (box)
        place.viewport = {box->width, box->height};
    else
        place.viewport = {readLength(root_.attribute("width").value(), kUsual.width).value_or(kUsual.width),
                          readLength(root_.attribute("height").value(), kUsual.height).value_or(kUsual.height)};
    return place;
}

std::variant<std::vector<ImportedPath>, FileError> SvgPaths::read() && {
    const std::optional<Place> place = outermost();
    const pugi::xml_node own = ownLayer();
    if (!place || !(own ? element(own, *place) : children(root_, *place)))
        return std::move(*fault_);
    if (paths_.empty())
        return errorOfFile(FileProblem::noPaths);
    return std::move(paths_);
}

std::variant<std::vector<ImportedPath>, FileError> SvgPaths::readOwn() && {
    const std::optional<Place> place = outermost();
    const pugi::xml_node own = ownLayer();
    if (!place || (own && !element(own, *place)))
        return std::move(*fault_);
    return std::move(paths_);
}

bool SvgPaths::children(const pugi::xml_node& parent, const Place& place) {
    return std::ranges::all_of(parent.children(), [&](const pugi::xml_node& child) {
        return child.type() != pugi::node_element || isDrawnElsewhere(nameOf(child).local) || element(child, place);
    });
}

bool SvgPaths::element(const pugi::xml_node& element, Place place) {
    if (++visited_ > limits::kXmlElements)
        return refuse(errorOfFile(FileProblem::tooManyElements, {limits::kXmlElements}));
    const auto [prefix, name] = nameOf(element);
    if (prefix != nameOf(root_).prefix || !isDisplayed(element)) // another vocabulary, or nothing to see
        return true;
    if (const pugi::xml_attribute transform = element.attribute("transform")) {
        const std::optional<Affine> read = readTransform(transform.value());
        if (!read)
            return refuse(element, "transform");
        place.map = place.map * *read;
    }
    const bool isLayer = element.attribute("inkscape:groupmode").value() == std::string_view("layer");
    if (const pugi::xml_attribute label = element.attribute("inkscape:label"); label && !isLayer)
        place.name = label.value();
    if (name == "use")
        return use(element, std::move(place));
    if (name == "svg")
        return nested(element, std::move(place), {});
    if (name == "g" || name == "a" || name == "switch")
        return children(element, place);
    return shape(element, place);
}

bool SvgPaths::use(const pugi::xml_node& element, Place place) {
    std::string_view reference = element.attribute("href").value();
    if (reference.empty())
        reference = element.attribute("xlink:href").value();
    const pugi::xml_node target = reference.starts_with('#') ? named(reference.substr(1)) : pugi::xml_node();
    if (!target)
        return true; // elsewhere, or nowhere: it draws nothing
    if (++place.uses > limits::kSvgUses)
        return refuse(errorOfFile(FileProblem::nestedTooDeep, {limits::kSvgUses}));
    const std::optional<ViewBox> own = placeOf(element, place.viewport);
    if (!own)
        return false;
    place.map = place.map * translation({own->x, own->y});
    const std::string_view name = nameOf(target).local;
    if (name != "symbol")
        return this->element(target, std::move(place));
    return nested(target, std::move(place), SvgViewport{own->width, own->height});
}

bool SvgPaths::nested(const pugi::xml_node& element, Place place, std::optional<SvgViewport> size) {
    if (!size) {
        const std::optional<ViewBox> own = placeOf(element, place.viewport);
        if (!own)
            return false;
        place.map = place.map * translation({own->x, own->y});
        size = SvgViewport{own->width, own->height};
    }
    place.viewport = *size;
    std::optional<ViewBox> box;
    if (!viewBoxOf(element, box))
        return false;
    if (box) {
        const bool isStretched = element.attribute("preserveAspectRatio").value() == std::string_view("none");
        place.map = place.map * mapInto(*size, *box, isStretched);
        place.viewport = {box->width, box->height};
    }
    return children(element, place);
}

bool SvgPaths::shape(const pugi::xml_node& element, const Place& place) {
    auto read = subpathsOf(element, place.viewport);
    if (const AttributeFault* fault = std::get_if<AttributeFault>(&read))
        return refuse(element, fault->attribute);
    for (Path& path : std::get<std::vector<Path>>(read)) {
        for (Point& p : path.points) {
            p = place.map(p);
            if (!isWithin(p, limits::kNumber))
                return refuse(element, "transform");
        }
        points_ += path.points.size();
        if (points_ > limits::kPointsInSheet)
            return refuse(errorOfFile(FileProblem::tooMany, {static_cast<double>(limits::kPointsInSheet)}));
        paths_.push_back({place.name, std::move(path), element.attribute("id").value()});
    }
    return true;
}

bool SvgPaths::refuse(const pugi::xml_node& element, std::string_view attribute) {
    FileError error = errorAtByte(FileProblem::badAttribute, svg_, static_cast<std::size_t>(element.offset_debug()));
    error.words = {std::string(attribute)};
    return refuse(std::move(error));
}

pugi::xml_node SvgPaths::named(std::string_view id) {
    if (ids_.empty()) {
        struct Gather : pugi::xml_tree_walker {
            std::unordered_map<std::string_view, pugi::xml_node>& ids;
            explicit Gather(std::unordered_map<std::string_view, pugi::xml_node>& to)
                : ids(to) {}
            bool for_each(pugi::xml_node& node) override {
                if (const pugi::xml_attribute attribute = node.attribute("id"))
                    ids.emplace(attribute.value(), node);
                return true;
            }
        };
        Gather gather(ids_);
        pugi::xml_node root = root_;
        root.traverse(gather);
    }
    const auto found = ids_.find(id);
    return found == ids_.end() ? pugi::xml_node() : found->second;
}

std::optional<double> SvgPaths::length(const pugi::xml_node& element, const char* name, double whole,
                                       double otherwise) {
    const pugi::xml_attribute attribute = element.attribute(name);
    if (!attribute || attribute.value() == std::string_view("auto"))
        return otherwise;
    const std::optional<double> read = readLength(attribute.value(), whole);
    if (!read)
        refuse(element, name);
    return read;
}

std::optional<ViewBox> SvgPaths::placeOf(const pugi::xml_node& element, const SvgViewport& around) {
    const auto x = length(element, "x", around.width, 0);
    const auto y = length(element, "y", around.height, 0);
    const auto width = length(element, "width", around.width, around.width);
    const auto height = length(element, "height", around.height, around.height);
    if (!x || !y || !width || !height)
        return {};
    return ViewBox{*x, *y, *width, *height};
}

bool SvgPaths::viewBoxOf(const pugi::xml_node& element, std::optional<ViewBox>& box) {
    const pugi::xml_attribute attribute = element.attribute("viewBox");
    if (attribute)
        box = readViewBox(attribute.value());
    return !attribute || box || refuse(element, "viewBox");
}

/// What `read` makes of the text, where it is XML.
template <class Read>
std::variant<std::vector<ImportedPath>, FileError> inSvg(std::string_view svg, Read read) {
    pugi::xml_document xml;
    if (std::optional<FileError> error = openSvg(svg, xml))
        return std::move(*error);
    const pugi::xml_node root = xml.document_element();
    return read(SvgPaths(svg, root));
}

} // namespace

std::variant<std::vector<ImportedPath>, FileError> readSvgPaths(std::string_view svg) {
    return inSvg(svg, [](SvgPaths paths) { return std::move(paths).read(); });
}

std::variant<std::vector<ImportedPath>, FileError> readOwnCurves(std::string_view svg) {
    return inSvg(svg, [](SvgPaths paths) { return std::move(paths).readOwn(); });
}

std::variant<std::vector<ImportedPath>, FileError> readPathsOfData(std::string_view data) {
    auto read = readPathData(data);
    if (FileError* error = std::get_if<FileError>(&read))
        return std::move(*error);
    std::vector<ImportedPath> imported;
    for (Path& path : std::get<std::vector<Path>>(read)) {
        for (Point& p : path.points)
            p.y = -p.y; // it goes down in SVG
        imported.push_back({{}, std::move(path), {}});
    }
    if (imported.empty())
        return errorOfFile(FileProblem::noPaths);
    return imported;
}

} // namespace kriva
