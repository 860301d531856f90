#include "core/io/svg/svg_animation.h"

#include "core/io/numbers/plain_number.h"

#include <algorithm>

namespace kriva {

std::vector<FrameLayer> frameLayers(std::span<const Drawing> frames, const TextSource& texts) {
    const auto layerOf = [&](const FrameLayer::Part& part) -> const Layer& {
        return frames[part.frame].figure.layers[part.index];
    };
    std::vector<FrameLayer> layers;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        auto labels = placedLabels(frames[f].figure, frames[f].page, texts);
        auto behind = layers.begin();
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const std::string_view name = frames[f].figure.layers[i].name;
            auto at = std::ranges::find(layers, name,
                                        [&](const FrameLayer& layer) { return layerOf(layer.parts.front()).name; });
            if (at == layers.end())
                at = layers.insert(behind, FrameLayer());
            at->parts.push_back({f, i, std::move(labels[i])});
            behind = at + 1;
        }
    }
    for (FrameLayer& layer : layers) {
        const FrameLayer::Part& first = layer.parts.front();
        layer.standsStill =
            layer.parts.size() == frames.size() && std::ranges::all_of(layer.parts, [&](const FrameLayer::Part& part) {
                return layerOf(part) == layerOf(first) && part.labels == first.labels;
            });
    }
    return layers;
}

std::string groupOfFrame(std::size_t index, std::size_t count, double seconds) {
    const auto part = [&](std::size_t i) {
        return plainNumber(static_cast<double>(i) / static_cast<double>(count), 6);
    };
    std::string values = index == 0 ? "visible" : "hidden;visible";
    std::string times = index == 0 ? "0" : "0;" + part(index);
    if (index + 1 < count) {
        values += ";hidden";
        times += ";" + part(index + 1);
    }
    const std::string duration = plainNumber(static_cast<double>(count) * seconds, 3);
    std::string group = index == 0 ? R"(<g visibility="visible">)" : R"(<g visibility="hidden">)";
    group += R"(<animate attributeName="visibility" calcMode="discrete" repeatCount="indefinite")";
    group.append(" dur=\"").append(duration).append("s\" values=\"").append(values);
    return group.append("\" keyTimes=\"").append(times).append("\"/>");
}

} // namespace kriva
