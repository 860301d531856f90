#include "core/exchange/curve_svg.h"

#include "core/io/svg_writer.h"

namespace kriva {

std::optional<std::string> writeCurveSvg(const Curve& curve, std::optional<double> mmPerUnit, const TextSource& texts) {
    SvgContent content;
    content.figure = figureOf(curve, {0, false}); // without what is derived from it
    std::erase_if(content.figure.layers, [](const Layer& layer) { return layer.name != "curve"; });
    if (content.figure.layers.empty() || content.figure.layers.front().strokes.empty())
        return {};
    content.page = pageOf(boxOf(content.figure), mmPerUnit);
    content.title = nameOf(curve).empty() ? texts.translate(captionOf(curve.index())) : nameOf(curve);
    content.hasPaper = false;
    return writeSvg(content, texts);
}

} // namespace kriva
