#include "core/io/svg/curve_svg.h"

#include "core/bezier/cubic_pieces.h"
#include "core/document/sheet_figure.h"
#include "core/io/svg/svg_path.h"
#include "core/io/svg/svg_writer.h"

#include <algorithm>
#include <cmath>

namespace kriva {
namespace {

/// The curve without what is derived from it; no layer where there is nothing to draw.
Figure bareFigure(const Curve& curve) {
    Figure figure = figureOf(curve, {0, false});
    std::erase_if(figure.layers, [](const Layer& layer) { return layer.name != kCurveLayer || layer.strokes.empty(); });
    return figure;
}

/// The path with cubics for its pieces of degree 4 and above.
Path withCubics(const Path& path, Tolerance tolerance) {
    std::vector<Points> pieces;
    forEachPiece(path, [&](std::span<const Point> piece) {
        if (piece.size() <= 4) {
            pieces.emplace_back(piece.begin(), piece.end());
            return;
        }
        for (const Cubic& cubic : cubicPieces(piece, tolerance))
            pieces.emplace_back(cubic.begin(), cubic.end());
    });
    return chain(pieces, path.isClosed);
}

} // namespace

std::optional<std::string> writeCurveSvg(const Curve& curve, std::optional<double> mmPerUnit, const TextSource& texts) {
    Drawing drawing;
    drawing.figure = bareFigure(curve);
    if (drawing.figure.layers.empty())
        return {};
    drawing.page = pageOf(boxOf(drawing.figure), mmPerUnit);
    drawing.title = nameOf(curve).empty() ? texts.translate(captionOf(curve.index())) : nameOf(curve);
    drawing.hasPaper = false;
    return writeSvg(drawing, texts);
}

std::optional<std::string> writeCurvePathData(const Curve& curve) {
    const Figure figure = bareFigure(curve);
    if (figure.layers.empty())
        return {};
    constexpr double kOfHigherDegrees = 1e-9;
    const Box box = boxOf(figure);
    const double side = std::max({std::abs(box.xmin), std::abs(box.xmax), std::abs(box.ymin), std::abs(box.ymax)});
    Page page; // of the curve's own units, with its corner at the origin
    page.box = {0, 0, 0, 0};
    page.width = page.height = side > 0 ? side : 1;
    std::string data;
    for (const Stroke& stroke : figure.layers.front().strokes) {
        const std::string path = pathData(withCubics(stroke.path, {kOfHigherDegrees * side}), page, decimalsOf(page));
        data.append(data.empty() || path.empty() ? "" : " ").append(path);
    }
    return data;
}

} // namespace kriva
