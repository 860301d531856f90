#pragma once

#include <optional>

namespace kriva {

/// A place in the animation of a curve: a stage of its algorithm (elevations, levels of subdivision, steps of the
/// combined algorithm), or its parameter t.
struct FramePlace {
    enum class Over { stage, t };
    Over over = Over::stage;
    double at = 0; ///< whole for stages: elevations and levels from 0, steps from 1
    friend constexpr bool operator==(const FramePlace&, const FramePlace&) = default;
};

/// A curve, or a sheet with its active curve, as it is there, and after which stage its layers are hidden; nothing
/// shows all.
template <class Value>
struct Frame {
    Value value;
    std::optional<int> layerStage = {};
};

} // namespace kriva
