#include "core/io/svg/drawn_document.h"

#include "core/bezier/elevate.h"
#include "core/document/limit_check.h"
#include "core/document/sheet_figure.h"
#include "core/figure/labels.h"
#include "core/io/svg/imported.h"
#include "core/io/svg/svg_path.h"
#include "core/io/svg/svg_reader.h"
#include "core/io/svg/xml/svg_names.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

namespace kriva {
namespace {

/// Millimetres: what other programs round away.
constexpr double kRounding = 0.001;

using Paths = std::vector<ImportedPath>;

std::string idOf(int curve) {
    return std::string(kSvgCurveId) + decimal(curve);
}

/// By the ids of their elements.
using PathsOfIds = std::unordered_map<std::string, Paths>;

/// What the file would draw of the document, read as the file is: a path for each curve. Where a curve leaves the range
/// of doubles in between, its further parts have no id.
PathsOfIds ownPaths(const Sheet& sheet, const DrawnSheet& drawn) {
    PathsOfIds own;
    for (const int index : drawn.curves) {
        const Figure figure = figureOf(sheet.curves[static_cast<std::size_t>(index)], {index, false});
        std::string id = idOf(index);
        for (const Layer& layer : figure.layers)
            for (const Stroke& stroke : layer.name == kCurveLayer ? layer.strokes : std::vector<Stroke>()) {
                auto read = readPathsOfData(pathData(stroke.path, pageOf(drawn), drawn.decimals));
                if (Paths* paths = std::get_if<Paths>(&read))
                    std::ranges::move(*paths, std::back_inserter(own[std::exchange(id, {})]));
            }
    }
    return own;
}

/// Its pieces as cubics: other programs write lines and parabolas as such. Those without length are nowhere.
Points asCubics(const Path& path) {
    Points cubics;
    forEachPiece(path, [&](std::span<const Point> piece) {
        if (std::ranges::all_of(piece, [&](Point p) { return p == piece.front(); }))
            return;
        const Points cubic = elevated(piece, 4 - static_cast<int>(piece.size()));
        cubics.insert(cubics.end(), cubic.begin(), cubic.end());
    });
    return cubics;
}

bool drawTheSame(const ImportedPath& a, const ImportedPath& b) {
    return a.path.isClosed == b.path.isClosed &&
           std::ranges::equal(asCubics(a.path), asCubics(b.path),
                              [](Point p, Point q) { return distance(p, q) <= kRounding; });
}

/// Curves for paths of the page; nothing where the sheet refuses them.
std::optional<std::vector<Curve>> curvesOf(Paths paths, const DrawnSheet& drawn) {
    for (ImportedPath& imported : paths)
        for (Point& p : imported.path.points)
            p = inDocument(drawn, {p.x, -p.y});
    auto curves = importedCurves(paths, drawn.sheet);
    if (std::holds_alternative<FileError>(curves))
        return {};
    return std::get<std::vector<Curve>>(std::move(curves));
}

/// The curves of a sheet as the paths of a file draw them; nothing where the sheet cannot take them.
class Redrawing {
  public:
    Redrawing(const Sheet& sheet, const DrawnSheet& drawn, Paths paths)
        : sheet_(sheet)
        , drawn_(drawn)
        , own_(ownPaths(sheet, drawn)) {
        for (ImportedPath& path : paths) {
            Paths& place = own_.contains(path.id) ? edited_[path.id] : added_;
            place.push_back(std::move(path));
        }
    }

    [[nodiscard]] std::optional<std::vector<Curve>> curves() && {
        for (std::size_t i = 0; i < sheet_.curves.size(); ++i) {
            const std::string id = idOf(static_cast<int>(i));
            if (!own_.contains(id))
                curves_.push_back(sheet_.curves[i]); // it was not drawn
            else if (!redraw(sheet_.curves[i], own_[id], std::move(edited_[id])))
                return {};
        }
        if (!add(withoutParts(std::move(edited_[{}]))) || !add(std::move(added_)))
            return {};
        return std::move(curves_);
    }

  private:
    /// Paths without an id that are none of the further parts of curves.
    [[nodiscard]] Paths withoutParts(Paths paths) {
        std::erase_if(paths, [parts = own_[{}]](const ImportedPath& path) {
            return std::ranges::any_of(parts, [&](const ImportedPath& part) { return drawTheSame(part, path); });
        });
        return paths;
    }

    bool redraw(const Curve& curve, const Paths& own, Paths drawn) {
        if (std::ranges::equal(own, drawn, drawTheSame)) {
            curves_.push_back(curve);
            return true;
        }
        const std::size_t first = curves_.size();
        for (ImportedPath& path : drawn)
            path.name = nameOf(curve);
        if (!add(std::move(drawn)))
            return false;
        for (std::size_t i = first; i < curves_.size(); ++i)
            curves_[i] = withView(withStyle(std::move(curves_[i]), styleOf(curve)), viewOf(curve));
        return true;
    }

    bool add(Paths paths) {
        std::optional<std::vector<Curve>> curves = curvesOf(std::move(paths), drawn_);
        if (curves)
            std::ranges::move(*curves, std::back_inserter(curves_));
        return curves.has_value();
    }

    const Sheet& sheet_;
    const DrawnSheet& drawn_;
    PathsOfIds own_;
    PathsOfIds edited_; ///< what the file has under the same ids
    Paths added_;
    std::vector<Curve> curves_;
};

bool isOf(const DrawnSheet& drawn, const Sheet& sheet) {
    return !drawn.curves.empty() &&
           std::ranges::all_of(drawn.curves, [&](int i) { return static_cast<std::size_t>(i) < sheet.curves.size(); });
}

} // namespace

std::optional<Document> drawnDocument(std::string_view svg, const Document& inside) {
    const std::optional<DrawnSheet> drawn = readDrawnSheetFromSvg(svg);
    if (!drawn || !isOf(*drawn, inside.sheets[drawn->sheet]))
        return {};
    auto read = readOwnCurves(svg);
    if (std::holds_alternative<FileError>(read))
        return {};
    std::optional<std::vector<Curve>> curves =
        Redrawing(inside.sheets[drawn->sheet], *drawn, std::get<Paths>(std::move(read))).curves();
    if (!curves)
        return {};
    Document document = inside;
    Sheet& sheet = document.sheets[drawn->sheet];
    sheet.curves = std::move(*curves);
    if (sheet.curves == inside.sheets[drawn->sheet].curves || sheetLimitError(sheet))
        return {};
    const auto last = static_cast<int>(sheet.curves.size()) - 1;
    sheet.view.activeCurve = std::clamp(sheet.view.activeCurve, 0, std::max(0, last));
    document.active = drawn->sheet;
    return document;
}

} // namespace kriva
