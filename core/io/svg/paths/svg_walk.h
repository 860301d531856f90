#pragma once

#include "core/io/svg/paths/element_ids.h"
#include "core/io/svg/paths/map_trail.h"
#include "core/io/svg/paths/svg_paths.h"
#include "core/io/svg/paths/svg_view_box.h"
#include "core/io/svg/xml/svg_xml.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace kriva {

/// Goes through the elements of an SVG file in the order of drawing and gathers the paths that they draw.
class SvgWalk {
  public:
    explicit SvgWalk(const ParsedSvg& svg)
        : svg_(svg)
        , root_(svg.xml.document_element())
        , ids_(root_) {}

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

    /// A parent whose children are read one by one. Parents are kept here and not on the call stack, where a few `use`
    /// inside each other would have thousands of them.
    struct Parent {
        pugi::xml_node next; ///< child
        Place place;
        std::size_t steps = 0; ///< of the trail that lead to it
    };

    /// Where the outermost elements are; nothing where the page's size cannot be read.
    std::optional<Place> outermost();
    [[nodiscard]] pugi::xml_node ownLayer() const;

    // Each of these gives false where there is a fault.
    bool readAll();
    bool visit(const pugi::xml_node& element, const Place& place);
    bool children(const pugi::xml_node& parent, Place place) {
        parents_.push_back({parent.first_child(), std::move(place), 0});
        return true;
    }
    bool element(const pugi::xml_node& element, Place place);
    bool use(const pugi::xml_node& element, Place place);
    /// A nested `svg` or a `symbol`, in a viewport of this size where one is given.
    bool nested(const pugi::xml_node& element, Place place, std::optional<SvgViewport> size);
    bool shape(const pugi::xml_node& element, const Place& place);
    /// Moves the place by what an attribute of an element says.
    void move(Place& place, const Affine& by, const pugi::xml_node& element, std::string_view attribute) {
        place.map = place.map * by;
        trail_.add({by, element, attribute});
    }
    void moveTo(const ViewBox& box, Place& place, const pugi::xml_node& element) {
        move(place, translation({box.x, box.y}), element, std::abs(box.y) > std::abs(box.x) ? "y" : "x");
    }
    bool refuse(const pugi::xml_node& element, std::string_view attribute);
    bool refuseFar(const pugi::xml_node& shape, const Place& place, Point local);
    [[nodiscard]] FileError limitAt(FileProblem problem, const pugi::xml_node& element, double limit) const;
    bool refuse(FileError error) {
        fault_ = std::move(error);
        return false;
    }

    /// A length of an element, `otherwise` where it is missing; nothing where it cannot be read, which is told.
    std::optional<double> length(const pugi::xml_node& element, const char* name, double whole, double otherwise);
    /// Its x, y, width and height, by default those of the viewport around it; nothing where one cannot be read.
    std::optional<ViewBox> placeOf(const pugi::xml_node& element, const SvgViewport& around);
    /// Nothing where there is none; false where it cannot be read.
    bool viewBoxOf(const pugi::xml_node& element, std::optional<ViewBox>& box);

    const ParsedSvg& svg_;
    pugi::xml_node root_;
    ElementIds ids_;
    std::vector<Parent> parents_;
    MapTrail trail_;
    std::vector<ImportedPath> paths_;
    std::optional<FileError> fault_;
    int visited_ = 0;
    int uses_ = 0;
    std::size_t points_ = 0;
};

} // namespace kriva
