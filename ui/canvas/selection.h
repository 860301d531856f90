#pragma once

#include "core/document/editing/grip.h"
#include "core/figure/figure.h"
#include "ui/document/serial.h"

#include <optional>
#include <set>

namespace kriva::ui {

/// One grip of one curve of the sheet.
struct GripRef {
    Serial serial = 0;
    GripId id;
    friend constexpr auto operator<=>(const GripRef&, const GripRef&) = default;
};

using Selection = std::set<GripRef>;

[[nodiscard]] inline Selection united(Selection selection, Selection added) {
    selection.merge(added);
    return selection;
}
[[nodiscard]] inline Selection without(Selection selection, const Selection& removed) {
    std::erase_if(selection, [&](const GripRef& grip) { return removed.contains(grip); });
    return selection;
}

/// A mark that cannot be taken hold of: a point that was worked out from others.
struct MarkPlace {
    Role role = Role::point;
    Point at;
    friend bool operator==(const MarkPlace&, const MarkPlace&) = default;
};

/// What lies under a pixel: a grip, else a curve or a mark or both, else nothing.
struct Hit {
    std::optional<GripRef> grip;
    std::optional<Serial> curve;
    std::optional<MarkPlace> mark = {};
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// A place on a curve.
struct CurvePlace {
    Serial curve = 0;
    Point near; ///< as the pointer says it
};

} // namespace kriva::ui
