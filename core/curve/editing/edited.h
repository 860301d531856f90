#pragma once

#include <optional>
#include <vector>

namespace kriva {

/// Where each old point of a curve went: the new index by the old one, or kGone. An empty map moves nothing.
struct IndexMap {
    static constexpr int kGone = -1;
    std::vector<int> newIndex;

    [[nodiscard]] int operator()(int old) const {
        return newIndex.empty() ? old : newIndex[static_cast<std::size_t>(old)];
    }
    friend bool operator==(const IndexMap&, const IndexMap&) = default;
};

/// What an edit returns: the new value with all its counts valid, and how its points were renumbered.
template <class Curve>
struct Edited {
    Curve curve;
    IndexMap map;
};

/// What an edit returns that takes points away and fits what is left to the curve as it was.
template <class Curve>
struct Refitted {
    Edited<Curve> edited;
    /// How far what goes lies from the new curve, at most, measured at places spread over it, in document units;
    /// nothing where nothing was fitted.
    std::optional<double> deviation;
};

/// The map of `count` points when those at `removed` (ascending) go.
[[nodiscard]] inline IndexMap mapWithout(int count, const std::vector<int>& removed) {
    IndexMap map;
    map.newIndex.reserve(static_cast<std::size_t>(count));
    auto next = removed.begin();
    for (int old = 0, index = 0; old < count; ++old) {
        const bool goes = next != removed.end() && *next == old;
        if (goes)
            ++next;
        map.newIndex.push_back(goes ? IndexMap::kGone : index++);
    }
    return map;
}

/// The map of `count` points when one is inserted before the point `at`.
[[nodiscard]] inline IndexMap mapWithInserted(int count, int at) {
    IndexMap map;
    map.newIndex.reserve(static_cast<std::size_t>(count));
    for (int old = 0; old < count; ++old)
        map.newIndex.push_back(old < at ? old : old + 1);
    return map;
}

/// The map of `count` points when their order is turned round.
[[nodiscard]] inline IndexMap mapReversed(int count) {
    IndexMap map;
    for (int old = 0; old < count; ++old)
        map.newIndex.push_back(count - 1 - old);
    return map;
}

/// The elements that a map keeps, in their new order.
template <class Element>
[[nodiscard]] std::vector<Element> without(const std::vector<Element>& elements, const std::vector<int>& removed) {
    std::vector<Element> kept;
    kept.reserve(elements.size());
    auto next = removed.begin();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (next != removed.end() && static_cast<std::size_t>(*next) == i)
            ++next;
        else
            kept.push_back(elements[i]);
    }
    return kept;
}

/// The map of `count` points when `added` more come and only the ends stay what they were.
[[nodiscard]] inline IndexMap mapOfEnds(int count, int added) {
    IndexMap map;
    map.newIndex.assign(static_cast<std::size_t>(count), IndexMap::kGone);
    map.newIndex.front() = 0;
    map.newIndex.back() = count - 1 + added;
    return map;
}

} // namespace kriva
