#include "ui/canvas/drawing/visible_path.h"

#include "ui/canvas/base/qt_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kriva::ui {
namespace {

// Each halving halves the control polygon; 64 of them take 1e28 pixels, the most there can be, below any tolerance.
constexpr int kMostHalvings = 96;
// Pieces are left out so many at a time: what is drawn stays a part of the curve.
constexpr std::size_t kRun = 16;
// Pixels beyond the view, for antialiasing.
constexpr double kBeyond = 2;

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

[[nodiscard]] double squared(Vector v) {
    return dot(v, v);
}

/// Control points this close to the chord keep curve and chord within the tolerance of each other, both ways. Told
/// without a root or a division: this is asked of every piece of every curve in every frame.
[[nodiscard]] bool isFlat(std::span<const Point> curve, double tolerance) {
    const Vector chord = curve.back() - curve.front();
    const double squaredChord = squared(chord);
    const double squaredTolerance = tolerance * tolerance;
    return std::ranges::all_of(curve.subspan(1, curve.size() - 2), [&](Point p) {
        const Vector way = p - curve.front();
        const double along = dot(way, chord);
        if (along <= 0)
            return squared(way) <= squaredTolerance;
        if (along >= squaredChord)
            return squared(p - curve.back()) <= squaredTolerance;
        const double across = cross(chord, way);
        return across * across <= squaredTolerance * squaredChord;
    });
}

/// Strings lines together to polylines as long as each starts where the one before ended, without the points that are
/// close to the one before or to the line that they would be on.
class PolylineBuilder {
  public:
    PolylineBuilder(const Fineness& fineness, double penWidth, FrameLoad& load)
        : spacing_(fineness.spacing)
        , sleeve_(std::max(fineness.tolerance, kSleeve * fineness.spacing))
        , inkWidth_(std::max(1.0, penWidth))
        , load_(load) {}

    void addLine(Point from, Point to) {
        if (!end_ || *end_ != from) {
            finishPolyline();
            current_.append(toQt(from));
            keep(from);
        }
        if (hasCandidate() && (goesBack(to - kept_) || (isApart(to - kept_) && !isInCone(to - kept_))))
            append(*end_);
        end_ = to;
        if (isApart(to - kept_))
            narrowCone(to - kept_);
    }
    std::vector<QPolygonF> finished() {
        finishPolyline();
        return std::move(polylines_);
    }

  private:
    // A point this part of the spacing beside a line may as well be on it.
    static constexpr double kSleeve = 0.4;

    void append(Point p) {
        load_.points += 1;
        load_.ink += inkWidth_ * std::sqrt(squared(p - kept_));
        current_.append(toQt(p));
        keep(p);
    }
    void keep(Point p) {
        kept_ = p;
        reach_ = 0;
    }
    [[nodiscard]] bool hasCandidate() const { return reach_ > 0; }
    // Without roots: most points are close to the one before.
    [[nodiscard]] bool isApart(Vector way) const { return squared(way) >= spacing_ * spacing_; }
    [[nodiscard]] bool goesBack(Vector way) const {
        const double least = reach_ - sleeve_;
        return least > 0 && squared(way) < least * least;
    }
    /// The directions from the kept point that pass all points since then within the sleeve.
    [[nodiscard]] bool isInCone(Vector way) const { return cross(right_, way) >= 0 && cross(way, left_) >= 0; }
    void narrowCone(Vector way) {
        const double away = std::sqrt(squared(way));
        const Vector aside = sleeve_ / away * Vector{-way.y, way.x};
        if (!hasCandidate() || cross(way + aside, left_) > 0)
            left_ = way + aside;
        if (!hasCandidate() || cross(right_, way - aside) > 0)
            right_ = way - aside;
        reach_ = std::max(reach_, away);
    }
    void finishPolyline() {
        if (!end_)
            return;
        if (kept_ != *end_ || current_.size() == 1)
            append(*end_);
        polylines_.push_back(std::exchange(current_, {}));
        end_.reset();
    }

    double spacing_;
    double sleeve_;
    double inkWidth_;
    FrameLoad& load_;
    std::vector<QPolygonF> polylines_;
    QPolygonF current_;
    Point kept_;       ///< the last point of current_
    double reach_ = 0; ///< how far the points since then went
    Vector left_;      ///< the cone's two sides
    Vector right_;
    std::optional<Point> end_; ///< of the last line, which is not in current_ yet
};

/// Halves one piece, given in pixels, until what is left of it is flat or out of sight.
class Flattener {
  public:
    Flattener(const Box& seen, const Fineness& fineness, double penWidth, FrameLoad& load)
        : seen_(seen)
        , tolerance_(fineness.tolerance)
        , spacing_(fineness.spacing)
        , load_(load)
        , builder_(fineness, penWidth, load) {}

    void addPiece(std::span<const Point> piece) {
        if (piece.size() == 2)
            return addChord(piece.front(), piece.back());
        // Pieces on the stack are halved on top of it: it must not move.
        stack_.reserve(2 * piece.size() * kMostHalvings);
        add(piece, 0);
    }
    std::vector<QPolygonF> finished() { return builder_.finished(); }

  private:
    void add(std::span<const Point> curve, int halvings) {
        const Box box = boxOf(curve);
        if (!overlap(box, seen_) || load_.isTooMuch())
            return;
        const bool isDot = box.width() < spacing_ && box.height() < spacing_;
        if (curve.size() <= 2 || isDot || halvings == kMostHalvings || isFlat(curve, tolerance_)) {
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
    double spacing_;
    const FrameLoad& load_;
    PolylineBuilder builder_;
    Points stack_;
};

} // namespace

std::vector<QPolygonF> visiblePolylines(const Path& path, const Viewport& viewport, double penWidth,
                                        const Fineness& fineness, FrameLoad& load) {
    const Box seen = grown({0, 0, viewport.size.width(), viewport.size.height()}, penWidth + kBeyond);
    Flattener flattener(seen, fineness, penWidth, load);
    const auto share = static_cast<std::size_t>(fineness.share);
    Points pixels;
    forEachPiece(path, [&](std::span<const Point> piece) {
        const bool isOfShare = share == 1 || load.pieces / kRun % share == 0;
        ++load.pieces;
        if (!isOfShare || load.isTooMuch())
            return;
        pixels.clear();
        for (const Point p : piece)
            pixels.push_back(toCore(viewport.toPixels(p)));
        flattener.addPiece(pixels);
    });
    return flattener.finished();
}

} // namespace kriva::ui
