#include "ui/canvas/drawing/visible_path.h"

#include "core/geometry/segment.h"
#include "ui/canvas/qt_geometry.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace kriva::ui {
namespace {

// Each halving halves the control polygon; 64 of them take 1e28 pixels, the most there can be, below any tolerance.
constexpr int kMostHalvings = 96;

[[nodiscard]] bool isInside(Point p, const Box& box) {
    return p.x >= box.xmin && p.x <= box.xmax && p.y >= box.ymin && p.y <= box.ymax;
}

/// Rounding may leave a point of a very long line a little outside.
[[nodiscard]] Point heldIn(Point p, const Box& box) {
    return {std::clamp(p.x, box.xmin, box.xmax), std::clamp(p.y, box.ymin, box.ymax)};
}

/// Narrows the range of t to where `from + t * step` is between the bounds.
void narrow(double from, double step, std::pair<double, double> bounds, std::pair<double, double>& range) {
    if (step == 0) {
        if (from < bounds.first || from > bounds.second)
            range.second = -1;
        return;
    }
    const double first = (bounds.first - from) / step;
    const double second = (bounds.second - from) / step;
    range = {std::max(range.first, std::min(first, second)), std::min(range.second, std::max(first, second))};
}

/// The part of a line inside a box (Liang and Barsky, A new concept and method for line clipping, 1984).
[[nodiscard]] std::optional<std::pair<Point, Point>> clipped(Point from, Point to, const Box& box) {
    std::pair<double, double> range{0, 1};
    const Vector way = to - from;
    narrow(from.x, way.x, {box.xmin, box.xmax}, range);
    narrow(from.y, way.y, {box.ymin, box.ymax}, range);
    if (range.first > range.second)
        return std::nullopt;
    return std::pair(range.first > 0 ? heldIn(lerp(from, to, range.first), box) : from,
                     range.second < 1 ? heldIn(lerp(from, to, range.second), box) : to);
}

/// Control points this close to the chord keep curve and chord within the tolerance of each other, both ways.
[[nodiscard]] bool isFlat(std::span<const Point> curve, double tolerance) {
    return std::ranges::all_of(curve.subspan(1),
                               [&](Point p) { return distanceToSegment(p, curve.front(), curve.back()) <= tolerance; });
}

/// Strings lines together to polylines as long as each starts where the one before ended.
class PolylineBuilder {
  public:
    explicit PolylineBuilder(double spacing)
        : spacing_(spacing) {}

    void addLine(Point from, Point to) {
        if (!end_ || *end_ != from) {
            finishPolyline();
            current_.append(toQt(from));
            kept_ = from;
        }
        end_ = to;
        if (distance(kept_, to) >= spacing_) {
            current_.append(toQt(to));
            kept_ = to;
        }
    }
    std::vector<QPolygonF> finished() {
        finishPolyline();
        return std::move(polylines_);
    }

  private:
    void finishPolyline() {
        if (!end_)
            return;
        if (kept_ != *end_ || current_.size() == 1)
            current_.append(toQt(*end_));
        polylines_.push_back(std::exchange(current_, {}));
        end_.reset();
    }

    double spacing_;
    std::vector<QPolygonF> polylines_;
    QPolygonF current_;
    Point kept_;               ///< the last point of current_
    std::optional<Point> end_; ///< of the last line, which may have been left out of current_
};

/// Halves one piece, given in pixels, until what is left of it is flat or out of sight.
class Flattener {
  public:
    Flattener(const Box& seen, Fineness fineness)
        : seen_(seen)
        , tolerance_(fineness.tolerance)
        , builder_(fineness.spacing) {}

    void addPiece(std::span<const Point> piece) {
        // Pieces on the stack are halved on top of it: it must not move.
        stack_.reserve(2 * piece.size() * kMostHalvings);
        add(piece, 0);
    }
    std::vector<QPolygonF> finished() { return builder_.finished(); }

  private:
    void add(std::span<const Point> curve, int halvings) {
        if (!overlap(boxOf(curve), seen_))
            return;
        if (curve.size() <= 2 || halvings == kMostHalvings || isFlat(curve, tolerance_)) {
            addChord(curve.front(), curve.back());
            return;
        }
        const std::size_t count = curve.size();
        const std::size_t start = stack_.size();
        stack_.resize(start + 2 * count);
        const std::span<Point> halves = std::span(stack_).subspan(start);
        halve(curve, halves);
        add(halves.first(count), halvings + 1);
        add(halves.last(count), halvings + 1);
        stack_.resize(start);
    }
    /// De Casteljau's scheme at 1/2: the left half, then the right one.
    static void halve(std::span<const Point> curve, std::span<Point> halves) {
        const std::size_t count = curve.size();
        const std::span<Point> right = halves.subspan(count);
        std::ranges::copy(curve, right.begin());
        for (std::size_t row = 0; row < count; ++row) {
            halves[row] = right[0];
            for (std::size_t i = 0; i + row + 1 < count; ++i)
                right[i] = midpoint(right[i], right[i + 1]);
        }
    }
    void addChord(Point from, Point to) {
        if (isInside(from, seen_) && isInside(to, seen_))
            builder_.addLine(from, to);
        else if (const auto part = clipped(from, to, seen_))
            builder_.addLine(part->first, part->second);
    }

    Box seen_;
    double tolerance_;
    PolylineBuilder builder_;
    Points stack_;
};

} // namespace

std::vector<QPolygonF> visiblePolylines(const Path& path, const Viewport& viewport, double margin, Fineness fineness) {
    const Box seen = grown({0, 0, viewport.size.width(), viewport.size.height()}, margin);
    Flattener flattener(seen, fineness);
    Points pixels;
    forEachPiece(path, [&](std::span<const Point> piece) {
        pixels.clear();
        for (const Point p : piece)
            pixels.push_back(toCore(viewport.toPixels(p)));
        flattener.addPiece(pixels);
    });
    return flattener.finished();
}

} // namespace kriva::ui
