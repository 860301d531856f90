#pragma once

#include "core/figure/figure.h"
#include "core/figure/style/page.h"
#include "core/figure/text_source.h"

namespace kriva {

enum class TextAnchor { start, middle, end };

/// A label with its words and its place on the page, in millimetres.
struct PlacedLabel {
    std::string text;
    std::string subscript;
    std::string suffix;
    bool isVariable = false; ///< a letter of a formula, set in italics
    Point baseline;          ///< where the text starts, has its middle or ends, by its anchor
    TextAnchor anchor = TextAnchor::start;
    Role role = Role::label;
    friend bool operator==(const PlacedLabel&, const PlacedLabel&) = default;
};

/// Where the labels of each layer stand: beside their points, turned to their side and away from the neighbouring
/// labels of their layer, clear of lines, marks and each other as far as one of eight directions allows. Labels that
/// say the same in the same place become one. The width of letters is estimated, so that no font is needed. O(labels
/// (lines + labels)) up to a few hundred labels on ten thousand lines; figures beyond that are not searched for clear
/// places.
[[nodiscard]] std::vector<std::vector<PlacedLabel>> placedLabels(const Figure& figure, const Page& page,
                                                                 const TextSource& texts);

} // namespace kriva
