#include "core/io/svg/paths/svg_walk.h"

#include "core/curve/limits.h"
#include "core/io/svg/paths/svg_transform.h"
#include "core/io/svg/paths/visibility.h"
#include "core/io/svg/xml/svg_names.h"

namespace kriva {

std::optional<SvgWalk::Place> SvgWalk::outermost() {
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

pugi::xml_node SvgWalk::ownLayer() const {
    return root_.find_child_by_attribute("id", std::string(kSvgLayerId).append(kCurveLayer).c_str());
}

std::variant<std::vector<ImportedPath>, FileError> SvgWalk::read() && {
    const std::optional<Place> place = outermost();
    const pugi::xml_node own = ownLayer();
    if (!place || !(own ? visit(own, *place) : children(root_, *place)) || !readAll())
        return std::move(*fault_);
    if (paths_.empty())
        return errorOfFile(FileProblem::noPaths);
    return std::move(paths_);
}

std::variant<std::vector<ImportedPath>, FileError> SvgWalk::readOwn() && {
    const std::optional<Place> place = outermost();
    const pugi::xml_node own = ownLayer();
    if (!place || (own && !visit(own, *place)) || !readAll())
        return std::move(*fault_);
    return std::move(paths_);
}

bool SvgWalk::readAll() {
    while (!parents_.empty()) {
        Parent& parent = parents_.back();
        const pugi::xml_node child = parent.next;
        if (!child) {
            trail_.shrinkTo(parent.steps);
            parents_.pop_back();
            continue;
        }
        parent.next = child.next_sibling();
        const bool isDrawn = child.type() == pugi::node_element && !isDrawnElsewhere(nameOf(child).local);
        if (isDrawn && !visit(child, Place(parent.place)))
            return false;
    }
    return true;
}

/// An element with the steps of the trail that belong to it: until it is read, or as long as its children are.
bool SvgWalk::visit(const pugi::xml_node& element, const Place& place) {
    const std::size_t steps = trail_.size();
    const std::size_t parents = parents_.size();
    if (!this->element(element, place))
        return false;
    if (parents_.size() > parents)
        parents_.back().steps = steps;
    else
        trail_.shrinkTo(steps);
    return true;
}

bool SvgWalk::element(const pugi::xml_node& element, Place place) {
    if (++visited_ > limits::kXmlElements)
        return refuse(limitAt(FileProblem::tooManyElements, element, limits::kXmlElements));
    const auto [prefix, name] = nameOf(element);
    if (prefix != nameOf(root_).prefix || !isDisplayed(element)) // another vocabulary, or nothing to see
        return true;
    if (const pugi::xml_attribute transform = element.attribute("transform")) {
        const std::optional<Affine> read = readTransform(transform.value());
        if (!read)
            return refuse(element, "transform");
        move(place, *read, element, "transform");
    }
    const bool isLayer = element.attribute("inkscape:groupmode").value() == std::string_view("layer");
    if (const pugi::xml_attribute label = element.attribute("inkscape:label"); label && !isLayer)
        place.name = label.value();
    if (name == "use")
        return use(element, std::move(place));
    if (name == "svg")
        return nested(element, std::move(place), {});
    if (name == "g" || name == "a" || name == "switch")
        return children(element, std::move(place));
    return shape(element, place);
}

bool SvgWalk::use(const pugi::xml_node& element, Place place) {
    std::string_view reference = element.attribute("href").value();
    if (reference.empty())
        reference = element.attribute("xlink:href").value();
    const pugi::xml_node target = reference.starts_with('#') ? ids_.find(reference.substr(1)) : pugi::xml_node();
    if (!target)
        return true; // elsewhere, or nowhere: it draws nothing
    if (++place.uses > limits::kSvgUseNesting)
        return refuse(limitAt(FileProblem::usedTooDeep, element, limits::kSvgUseNesting));
    if (++uses_ > limits::kSvgUses)
        return refuse(limitAt(FileProblem::tooManyUses, element, limits::kSvgUses));
    const std::optional<ViewBox> own = placeOf(element, place.viewport);
    if (!own)
        return false;
    moveTo(*own, place, element);
    const std::string_view name = nameOf(target).local;
    if (name != "symbol")
        return this->element(target, std::move(place));
    return nested(target, std::move(place), SvgViewport{own->width, own->height});
}

bool SvgWalk::nested(const pugi::xml_node& element, Place place, std::optional<SvgViewport> size) {
    if (!size) {
        const std::optional<ViewBox> own = placeOf(element, place.viewport);
        if (!own)
            return false;
        moveTo(*own, place, element);
        size = SvgViewport{own->width, own->height};
    }
    place.viewport = *size;
    std::optional<ViewBox> box;
    if (!viewBoxOf(element, box))
        return false;
    if (box) {
        const bool isStretched = element.attribute("preserveAspectRatio").value() == std::string_view("none");
        move(place, mapInto(*size, *box, isStretched), element, "viewBox");
        place.viewport = {box->width, box->height};
    }
    return children(element, std::move(place));
}

bool SvgWalk::shape(const pugi::xml_node& element, const Place& place) {
    auto read = subpathsOf(element, place.viewport);
    if (const AttributeFault* fault = std::get_if<AttributeFault>(&read))
        return refuse(element, fault->attribute);
    for (Path& path : std::get<std::vector<Path>>(read)) {
        for (Point& p : path.points) {
            const Point local = std::exchange(p, place.map(p));
            if (!isWithin(p, limits::kNumber))
                return refuseFar(element, place, local);
        }
        points_ += path.points.size();
        if (points_ > limits::kPointsInSheet)
            return refuse(limitAt(FileProblem::tooManyPoints, element, static_cast<double>(limits::kPointsInSheet)));
        paths_.push_back({place.name, std::move(path), element.attribute("id").value()});
    }
    return true;
}

bool SvgWalk::refuse(const pugi::xml_node& element, std::string_view attribute) {
    FileError error = errorAt(FileProblem::badAttribute, svg_, element);
    error.words = {std::string(attribute)};
    return refuse(std::move(error));
}

bool SvgWalk::refuseFar(const pugi::xml_node& shape, const Place& place, Point local) {
    const MapTrail::Step* step = trail_.culprit(local, limits::kNumber);
    FileError error = errorAt(FileProblem::farAttribute, svg_, step ? step->element : shape);
    error.words = {std::string(step ? step->attribute : farthestAttribute(shape, place.viewport))};
    error.numbers = {-limits::kNumber, limits::kNumber};
    return refuse(std::move(error));
}

FileError SvgWalk::limitAt(FileProblem problem, const pugi::xml_node& element, double limit) const {
    FileError error = errorAt(problem, svg_, element);
    error.numbers = {limit};
    return error;
}

std::optional<double> SvgWalk::length(const pugi::xml_node& element, const char* name, double whole, double otherwise) {
    const pugi::xml_attribute attribute = element.attribute(name);
    if (!attribute || attribute.value() == std::string_view("auto"))
        return otherwise;
    const std::optional<double> read = readLength(attribute.value(), whole);
    if (!read)
        refuse(element, name);
    return read;
}

std::optional<ViewBox> SvgWalk::placeOf(const pugi::xml_node& element, const SvgViewport& around) {
    const auto x = length(element, "x", around.width, 0);
    const auto y = length(element, "y", around.height, 0);
    const auto width = length(element, "width", around.width, around.width);
    const auto height = length(element, "height", around.height, around.height);
    if (!x || !y || !width || !height)
        return {};
    return ViewBox{*x, *y, *width, *height};
}

bool SvgWalk::viewBoxOf(const pugi::xml_node& element, std::optional<ViewBox>& box) {
    const pugi::xml_attribute attribute = element.attribute("viewBox");
    if (attribute)
        box = readViewBox(attribute.value());
    return !attribute || box || refuse(element, "viewBox");
}

} // namespace kriva
