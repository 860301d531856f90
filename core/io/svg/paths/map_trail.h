#pragma once

#include "core/geometry/affine.h"

#include <pugixml.hpp>

#include <string_view>
#include <vector>

namespace kriva {

/// The maps that a shape goes through, from the outermost one on, and what says each: to tell which one is at fault
/// where a point ends up beyond all limits.
class MapTrail {
  public:
    struct Step {
        Affine map;
        pugi::xml_node element;
        std::string_view attribute;
    };

    void add(const Step& step) { steps_.push_back(step); }
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    void shrinkTo(std::size_t size) { steps_.resize(size); }

    /// The last step that takes a point of the shape out of the limit; nullptr where it was beyond from the start.
    [[nodiscard]] const Step* culprit(Point local, double limit) const;

  private:
    std::vector<Step> steps_;
};

} // namespace kriva
