#pragma once

#include "core/figure/caption.h"
#include "core/geometry/box.h"

#include <optional>
#include <string>
#include <variant>

namespace kriva {

/// A place through which curves pass more than once.
struct PassedPlace {
    struct Pass {
        std::optional<int> curve; ///< its index in the sheet, where there are several
        int segment = 0;
        double t = 0; ///< in the segment
        friend bool operator==(const Pass&, const Pass&) = default;
    };
    Point at;
    std::vector<Pass> passes;
    friend bool operator==(const PassedPlace&, const PassedPlace&) = default;
};

/// More than could be told one by one.
struct MoreThan {
    int count = 0;
    friend bool operator==(const MoreThan&, const MoreThan&) = default;
};

/// One row of numbers for people: in the Results panel and in the table that `kriva report` prints.
struct Result {
    /// Points are places in the figure, vectors are not: derivatives, and coefficients that are pairs of numbers.
    /// A word of the field that is the same in every language ("C1", "G2") is a literal text.
    using Value = std::variant<double, int, std::string, Caption, Point, Points, Vector, std::vector<Vector>, Box,
                               std::vector<double>, PassedPlace, MoreThan>;
    Caption caption = Caption::none;
    std::string index;          ///< "3" of the fourth segment; empty where there is only one
    std::optional<Value> value; ///< nothing where the number does not exist
    friend bool operator==(const Result&, const Result&) = default;
};

} // namespace kriva
