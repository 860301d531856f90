#pragma once

#include "core/figure/label_placement.h"
#include "core/io/drawing/drawing.h"

namespace kriva {

/// A layer of frames that show one after the other.
struct FrameLayer {
    /// What it is in one frame.
    struct Part {
        std::size_t frame = 0;
        std::size_t index = 0; ///< of the layer in the figure of the frame
        std::vector<PlacedLabel> labels;
    };
    std::vector<Part> parts;
    bool standsStill = false; ///< all frames have it, and it is the same in all
};

/// The layers of all frames, in the order of drawing, which the frames share.
[[nodiscard]] std::vector<FrameLayer> frameLayers(std::span<const Drawing> frames, const TextSource& texts);

/// Opens a group (SMIL) that shows in the frame `index` of so many, each of so many seconds, over and over.
[[nodiscard]] std::string groupOfFrame(std::size_t index, std::size_t count, double seconds);

} // namespace kriva
