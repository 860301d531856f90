#pragma once

#include "core/curve/editing/grip.h"
#include "core/figure/figure.h"
#include "ui/canvas/base/viewport.h"
#include "ui/document/serial.h"

#include <optional>
#include <span>

namespace kriva::ui {

enum class SnapKind { grid, curve, point };

/// To where a dragged or added point snaps, and to what.
struct Snap {
    Point at;
    SnapKind kind = SnapKind::grid;
    friend bool operator==(const Snap&, const Snap&) = default;
};

/// What of a curve a point can snap to.
struct SnapTarget {
    Serial serial = 0;
    std::span<const Grip> grips = {};
    const Figure* figure = nullptr;
};

/// Along which axis a point may go.
enum class Freedom { both, x, y };

/// A point on its way.
struct SnappingPlace {
    Point at;
    Freedom freedom = Freedom::both;
    Serial curve = 0;                    ///< which changes as the point moves; 0 for none
    std::span<const GripId> moving = {}; ///< of that curve, ascending: what moves with the point
};

inline constexpr double kSnapReach = 10; ///< pixels

/// The nearest point of any curve within kSnapReach, but none that moves; else the nearest place of another curve
/// within it; else, with a grid, its nearest place. A point that keeps to an axis takes only what it finds along it.
/// Linear in grips and pieces of curves.
[[nodiscard]] std::optional<Snap> snapOf(const SnappingPlace& place, std::span<const SnapTarget> targets,
                                         const Viewport& viewport, bool hasGrid);

} // namespace kriva::ui
