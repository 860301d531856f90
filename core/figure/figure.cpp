#include "core/figure/figure.h"

#include "core/bezier/bounds.h"

#include <algorithm>
#include <iterator>

namespace kriva {
namespace {

template <class Element>
void append(std::vector<Element>& to, std::vector<Element>&& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

} // namespace

Path chain(const std::vector<Points>& pieces, bool isClosed) {
    Path path;
    path.isClosed = isClosed;
    path.degrees.reserve(pieces.size());
    path.points.reserve(pieces.empty() ? 0 : pieces.size() * (pieces.front().size() - 1) + 1);
    for (const Points& piece : pieces) {
        if (path.points.empty())
            path.points.push_back(piece.front());
        path.points.insert(path.points.end(), piece.begin() + 1, piece.end());
        path.degrees.push_back(static_cast<int>(piece.size()) - 1);
    }
    return path;
}

Points pointsOf(const Path& path) {
    if (path.degrees.size() <= 1)
        return path.points;
    Points points{path.points.front()};
    forEachPiece(path, [&](std::span<const Point> piece) { points.push_back(piece.back()); });
    if (path.isClosed)
        points.pop_back();
    return points;
}

Figure styled(Figure figure, const CurveStyle& style) {
    for (Layer& layer : figure.layers) {
        if (!style.hasLabels)
            layer.labels.clear();
        for (Marks& marks : layer.marks)
            if (marks.role == Role::point || marks.role == Role::knot)
                marks.marker = style.marker;
    }
    return figure;
}

Figure united(std::vector<Figure> figures, std::span<const LayerInfo> order) {
    Figure result;
    for (const LayerInfo& info : order) {
        Layer layer;
        layer.name = info.name;
        bool isThere = false;
        for (Figure& figure : figures) {
            for (Layer& part : figure.layers) {
                if (part.name != info.name)
                    continue;
                isThere = true;
                append(layer.strokes, std::move(part.strokes));
                append(layer.marks, std::move(part.marks));
                append(layer.labels, std::move(part.labels));
            }
        }
        if (isThere)
            result.layers.push_back(std::move(layer));
    }
    return result;
}

bool isShown(const LayerInfo& layer, const SheetView& view) {
    const auto stored = view.layers.find(std::string(layer.name));
    return stored == view.layers.end() ? layer.isShownAtFirst : stored->second;
}

bool isDrawn(std::string_view layer, std::span<const LayerInfo> table, const FigureContext& context) {
    const auto info = std::ranges::find(table, layer, &LayerInfo::name);
    if (info == table.end())
        return true;
    if (info->isOfActiveCurve && !context.isActive)
        return false;
    if (!context.view)
        return !context.stage || info->stage <= *context.stage;
    if (!context.stage)
        return isShown(*info, *context.view);
    const bool isOfThisStage = info->stage == *context.stage && !context.view->layers.contains(std::string(layer));
    return info->stage <= *context.stage && (isOfThisStage || isShown(*info, *context.view));
}

Figure shownLayers(Figure figure, std::span<const LayerInfo> table, const FigureContext& context) {
    std::erase_if(figure.layers, [&](const Layer& layer) { return !isDrawn(layer.name, table, context); });
    return figure;
}

Box boxOf(const Figure& figure) {
    Box box;
    for (const Layer& layer : figure.layers) {
        for (const Stroke& stroke : layer.strokes)
            forEachPiece(stroke.path, [&](std::span<const Point> piece) { box = united(box, tightBounds(piece)); });
        for (const Marks& marks : layer.marks)
            box = united(box, boxOf(marks.at));
        for (const Label& label : layer.labels)
            extend(box, label.at);
    }
    return box;
}

} // namespace kriva
