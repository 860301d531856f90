#pragma once

#include <pugixml.hpp>

#include <string_view>
#include <unordered_map>

namespace kriva {

/// The elements of an SVG file by their ids, gathered when the first one is asked for.
class ElementIds {
  public:
    /// The root's document outlives this.
    explicit ElementIds(const pugi::xml_node& root)
        : root_(root) {}

    /// The first element with an id; an empty node where there is none.
    [[nodiscard]] pugi::xml_node find(std::string_view id);

  private:
    pugi::xml_node root_;
    std::unordered_map<std::string_view, pugi::xml_node> elements_;
};

} // namespace kriva
