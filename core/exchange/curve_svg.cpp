#include "core/exchange/curve_svg.h"

#include "core/io/svg/svg_writer.h"

namespace kriva {

std::optional<std::string> writeCurveSvg(const Curve& curve, std::optional<double> mmPerUnit, const TextSource& texts) {
    Drawing drawing;
    drawing.figure = figureOf(curve, {0, false}); // without what is derived from it
    std::erase_if(drawing.figure.layers, [](const Layer& layer) { return layer.name != "curve"; });
    if (drawing.figure.layers.empty() || drawing.figure.layers.front().strokes.empty())
        return {};
    drawing.page = pageOf(boxOf(drawing.figure), mmPerUnit);
    drawing.title = nameOf(curve).empty() ? texts.translate(captionOf(curve.index())) : nameOf(curve);
    drawing.hasPaper = false;
    return writeSvg(drawing, texts);
}

} // namespace kriva
