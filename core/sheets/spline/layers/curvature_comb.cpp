#include "core/sheets/spline/layers/curvature_comb.h"

#include "core/bezier/bounds.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"

#include <algorithm>
#include <cassert>

namespace kriva {
namespace {

/// Of the diagonal of the curve's box.
constexpr double kLongestTooth = 0.2;
constexpr double kLeastRadius = 0.05;
/// So many times the median a curvature may be where its radius is smaller than that.
constexpr double kMostOfMedian = 10;

constexpr int kMostSteps = 32; // for each segment: an envelope through them looks smooth
constexpr int kLeastSteps = 2;
constexpr std::size_t kMostTeeth = 6000; // of a whole comb: what a frame can draw

std::optional<CombTooth> toothAt(std::span<const Point> segment, std::span<const Point> shape, double t) {
    const std::optional<double> bend = curvature(shape, t);
    if (!bend || !std::isfinite(*bend))
        return {};
    const Vector way = derivative(shape, t);
    const Vector along = way / length(way);
    return CombTooth{evaluate(segment, t), {along.y, -along.x}, *bend};
}

void addTooth(Layer& layer, Points& ends, const CombTooth& tooth, const CombScale& scale) {
    const Point end = endOf(tooth, scale);
    ends.push_back(end);
    if (end != tooth.foot)
        layer.strokes.push_back({polyline(Points{tooth.foot, end}), Role::comb});
}

void addEnvelope(Layer& layer, Points& ends) {
    if (ends.size() > 1)
        layer.strokes.push_back({polyline(ends), Role::comb, 1});
    ends.clear();
}

} // namespace

CombTeeth combTeeth(const std::vector<Points>& segments, const std::vector<Points>& shapes, int steps) {
    assert(segments.size() == shapes.size() && steps >= 1);
    CombTeeth teeth(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (int step = 0; step <= steps; ++step)
            teeth[i].push_back(toothAt(segments[i], shapes[i], static_cast<double>(step) / steps));
    return teeth;
}

CombScale combScale(const CombTeeth& teeth, const Box& box, double factor) {
    const double size = diagonal(box);
    std::vector<double> curvatures;
    for (const auto& segment : teeth)
        for (const std::optional<CombTooth>& tooth : segment)
            if (tooth)
                curvatures.push_back(std::abs(tooth->curvature));
    // What is straight up to rounding has a comb of nothing but rounding.
    constexpr double kStraight = 1e-9;
    const double most = curvatures.empty() ? 0 : std::ranges::max(curvatures);
    if (!std::isfinite(size) || most * size <= kStraight)
        return {};
    const auto middle = curvatures.begin() + static_cast<std::ptrdiff_t>(curvatures.size() / 2);
    std::ranges::nth_element(curvatures, middle);
    const double limit = std::max(kMostOfMedian * *middle, 1 / (kLeastRadius * size));
    const double longest = factor * kLongestTooth * size;
    return {longest / std::min(most, limit), longest};
}

Point endOf(const CombTooth& tooth, const CombScale& scale) {
    return tooth.foot + std::clamp(scale.scale * tooth.curvature, -scale.longest, scale.longest) * tooth.outwards;
}

Layer curvatureCombLayer(const std::vector<Points>& segments, const std::vector<Points>& shapes, double factor) {
    Layer layer{"curvature-comb"};
    Box box;
    for (const Points& segment : segments)
        box = united(box, tightBounds(segment));
    const int room = static_cast<int>(kMostTeeth / std::max<std::size_t>(segments.size(), 1));
    const CombTeeth teeth = combTeeth(segments, shapes, std::clamp(room, kLeastSteps, kMostSteps));
    const CombScale scale = combScale(teeth, box, factor);
    if (scale.longest == 0)
        return layer;
    for (const auto& segment : teeth) {
        Points ends;
        for (const std::optional<CombTooth>& tooth : segment) {
            if (tooth)
                addTooth(layer, ends, *tooth, scale);
            else
                addEnvelope(layer, ends);
        }
        addEnvelope(layer, ends);
    }
    return layer;
}

} // namespace kriva
