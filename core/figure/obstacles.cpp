#include "core/figure/obstacles.h"

#include "core/bezier/evaluate.h"

#include <algorithm>

namespace kriva {
namespace {

constexpr std::size_t kMostObstacles = 20'000;
constexpr int kMostChords = 48; ///< of one piece: a few millimetres each
constexpr double kCurveWeight = 3;
constexpr double kMarkCost = 8;
constexpr double kTextCost = 30;
constexpr double kMarkRadius = 0.9;

int chordsOf(std::size_t points) {
    return points <= 2 ? 1 : std::min(8 * static_cast<int>(points), kMostChords);
}

double weightOf(const Stroke& stroke) {
    return stroke.strength * (stroke.role == Role::curve || stroke.role == Role::run ? kCurveWeight : 1);
}

} // namespace

double lengthInside(const Box& box, Point from, Point to) {
    Box around{from.x, from.y, from.x, from.y};
    extend(around, to);
    if (!overlap(box, around))
        return 0;
    // Liang and Barsky, "A new concept and method for line clipping" (1984): the part from `enter` to `leave`.
    const Vector way = to - from;
    double enter = 0;
    double leave = 1;
    const auto clip = [&](double start, double step, double low, double high) {
        if (step == 0) {
            if (start < low || start > high)
                leave = -1;
            return;
        }
        const auto [first, last] = std::minmax({(low - start) / step, (high - start) / step});
        enter = std::max(enter, first);
        leave = std::min(leave, last);
    };
    clip(from.x, way.x, box.xmin, box.xmax);
    clip(from.y, way.y, box.ymin, box.ymax);
    return leave > enter ? (leave - enter) * length(way) : 0;
}

double Obstacles::covered(const Box& box) const {
    double sum = 0;
    for (const Line& line : lines_)
        sum += line.weight * lengthInside(box, line.from, line.to);
    const Box aroundMarks = grown(box, kMarkRadius);
    for (const Point mark : marks_)
        if (overlap(aroundMarks, {mark.x, mark.y, mark.x, mark.y}))
            sum += kMarkCost;
    for (const Box& text : texts_)
        if (overlap(box, text))
            sum += kTextCost;
    return sum;
}

Obstacles obstaclesOf(const Figure& figure, const Page& page) {
    Obstacles obstacles;
    std::size_t count = 0;
    for (const Layer& layer : figure.layers) {
        for (const Stroke& stroke : layer.strokes) {
            forEachPiece(stroke.path, [&](std::span<const Point> piece) {
                const int chords = chordsOf(piece.size());
                if ((count += static_cast<std::size_t>(chords)) > kMostObstacles)
                    return;
                Point from = onPage(page, piece.front());
                for (int i = 1; i <= chords; ++i) {
                    const Point to = onPage(page, evaluate(piece, static_cast<double>(i) / chords));
                    obstacles.addLine(from, to, weightOf(stroke));
                    from = to;
                }
            });
        }
        for (const Marks& marks : layer.marks)
            for (const Point mark : marks.at)
                if (++count <= kMostObstacles)
                    obstacles.addMark(onPage(page, mark));
    }
    return obstacles;
}

} // namespace kriva
