#include "core/io/svg/paths/element_ids.h"

namespace kriva {
namespace {

struct GatherIds : pugi::xml_tree_walker {
    explicit GatherIds(std::unordered_map<std::string_view, pugi::xml_node>& to)
        : elements(to) {}
    bool for_each(pugi::xml_node& node) override {
        if (const pugi::xml_attribute id = node.attribute("id"))
            elements.emplace(id.value(), node);
        return true;
    }
    std::unordered_map<std::string_view, pugi::xml_node>& elements;
};

} // namespace

pugi::xml_node ElementIds::find(std::string_view id) {
    if (elements_.empty()) {
        GatherIds gather(elements_);
        root_.traverse(gather);
    }
    const auto found = elements_.find(id);
    return found == elements_.end() ? pugi::xml_node() : found->second;
}

} // namespace kriva
