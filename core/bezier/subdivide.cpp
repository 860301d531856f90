#include "core/bezier/subdivide.h"

#include "core/bezier/place_lanes.h"
#include "core/polynomial/casteljau.h"

#include <algorithm>
#include <cassert>

namespace kriva {

namespace {

using Vectors = std::vector<Vector>;

Vectors vectorsFromStart(std::span<const Point> curve) {
    Vectors vectors(curve.size());
    writeFromStart(curve, vectors);
    return vectors;
}

Points pointsFrom(Point start, std::span<const Vector> vectors) {
    Points points;
    points.reserve(vectors.size());
    for (const Vector v : vectors)
        points.push_back(start + v);
    return points;
}

void writePoints(Point start, std::span<const Vector> vectors, std::span<Point> points) {
    for (std::size_t i = 0; i < vectors.size(); ++i)
        points[i] = start + vectors[i];
}

/// Splits a row whose size the compiler knows, so that it stays in registers.
template <std::size_t size>
void splitShort(const Point* curve, double t, Point* left, Point* right) {
    const Point start = curve[0];
    const Point end = curve[size - 1];
    std::array<Vector, size> row;
    std::array<Vector, size> before;
    for (std::size_t i = 0; i < size; ++i)
        row[i] = curve[i] - start;
    splitInPlace(std::span<Vector>(row), std::span<Vector>(before), t);
    for (std::size_t i = 0; i < size; ++i)
        left[i] = start + before[i];
    for (std::size_t i = 0; i + 1 < size; ++i)
        right[i] = start + row[i];
    right[size - 1] = end;
}

[[gnu::noinline]] void splitAny(std::span<const Point> curve, double t, std::span<Point> left, std::span<Point> right) {
    const Point start = curve.front();
    const Point end = curve.back();
    RowBuffer<Vector> after(curve.size());
    RowBuffer<Vector> before(curve.size());
    writeFromStart(curve, after.row());
    splitInPlace(after.row(), before.row(), t);
    writePoints(start, before.row(), left);
    writePoints(start, after.row(), right);
    right.back() = end;
}

/// The pieces of as many curves of one degree as there are lanes, level by level, each in the place of its chain.
class LaneSplitter {
  public:
    LaneSplitter(std::size_t size, double t, int levels)
        : size_(size)
        , t_(t)
        , levels_(levels)
        , blocks_((static_cast<std::size_t>(levels) + 1) * size)
        , depths_(static_cast<std::size_t>(levels) + 1) {}

    /// Control vector `index` of the curve in that lane.
    void set(std::size_t lane, std::size_t index, Vector v) {
        blocks_[index].x[lane] = v.x;
        blocks_[index].y[lane] = v.y;
    }
    /// Writes the chain of lane k from `chains[k]` on.
    [[gnu::always_inline]] void write(Point start, const std::array<Point*, kLanes>& chains) {
        const PlaceLanes origin = PlaceLanes::at(start);
        depths_[0] = 0;
        std::size_t leaf = 0;
        // The last block is the first of those that are left.
        for (std::size_t count = 1; count > 0; --count, leaf += size_ - 1) {
            for (; depths_[count - 1] < levels_; ++count) {
                splitBlock(&blocks_[(count - 1) * size_], &blocks_[count * size_]);
                depths_[count] = ++depths_[count - 1];
            }
            for (std::size_t i = 0; i < size_; ++i)
                (origin + blocks_[(count - 1) * size_ + i])
                    .write({chains[0] + leaf + i, chains[1] + leaf + i, chains[2] + leaf + i, chains[3] + leaf + i});
        }
    }

  private:
    [[gnu::always_inline]] void splitBlock(PlaceLanes* row, PlaceLanes* left) const {
        Lanes t;
        spread(t_, t);
        const Lanes s = 1 - t;
        for (std::size_t count = size_; count > 0; --count) {
            PlaceLanes before = row[0];
            left[size_ - count] = before;
            for (std::size_t i = 0; i + 1 < count; ++i) {
                const PlaceLanes next = row[i + 1];
                row[i] = s * before + t * next;
                before = next;
            }
        }
    }

    std::size_t size_;
    double t_;
    int levels_;
    std::vector<PlaceLanes> blocks_;
    std::vector<int> depths_;
};

/// The control vectors of the 2^levels pieces.
std::vector<Vectors> piecesOf(Vectors whole, double t, int levels) {
    std::vector<Vectors> level{std::move(whole)};
    for (int i = 0; i < levels; ++i) {
        std::vector<Vectors> next;
        next.reserve(2 * level.size());
        for (Vectors& piece : level) {
            Vectors left(piece.size());
            splitInPlace(std::span(piece), std::span(left), t);
            next.push_back(std::move(left));
            next.push_back(std::move(piece));
        }
        level = std::move(next);
    }
    return level;
}

// Halvings until each lane has a curve.
constexpr int kLaneLevels = 2;
static_assert(1U << kLaneLevels == kLanes);

} // namespace

Triangle deCasteljau(std::span<const Point> curve, double t) {
    assert(!curve.empty());
    return deCasteljau(curve, std::vector<double>(curve.size() - 1, t));
}

Triangle deCasteljau(std::span<const Point> curve, std::span<const double> parameters) {
    assert(!curve.empty() && parameters.size() + 1 == curve.size());
    Triangle rows{Points(curve.begin(), curve.end())};
    Vectors row = vectorsFromStart(curve);
    for (const double t : parameters) {
        interpolateRow(std::span(row), t);
        row.pop_back();
        rows.push_back(pointsFrom(curve.front(), row));
    }
    return rows;
}

void split(std::span<const Point> curve, double t, std::span<Point> left, std::span<Point> right) {
    assert(!curve.empty() && left.size() == curve.size() && right.size() == curve.size());
    switch (curve.size()) {
    case 2:
        return splitShort<2>(curve.data(), t, left.data(), right.data());
    case 3:
        return splitShort<3>(curve.data(), t, left.data(), right.data());
    case 4:
        return splitShort<4>(curve.data(), t, left.data(), right.data());
    default:
        return splitAny(curve, t, left, right);
    }
}

Halves split(std::span<const Point> curve, double t) {
    Halves halves{Points(curve.size()), Points(curve.size())};
    split(curve, t, halves.left, halves.right);
    return halves;
}

void part(std::span<const Point> curve, double from, double to, std::span<Point> result) {
    assert(!curve.empty() && result.size() == curve.size() && 0 <= from && from <= to && to <= 1);
    const Point start = curve.front();
    const Point end = curve.back();
    RowBuffer<Vector> whole(curve.size());
    RowBuffer<Vector> before(curve.size());
    writeFromStart(curve, whole.row());
    std::span<Vector> row = whole.row();
    if (to < 1) {
        splitInPlace(row, before.row(), to);
        row = before.row();
    }
    // Of the part before `to`; from <= to, so this is at most 1. A part of no width at 0 is the first point alone.
    if (from > 0)
        splitInPlace(row, to < 1 ? whole.row() : before.row(), from / to);
    writePoints(start, row, result);
    if (to == 1)
        result.back() = end;
}

Points part(std::span<const Point> curve, double from, double to) {
    Points points(curve.size());
    part(curve, from, to, points);
    return points;
}

void writePieces(std::span<const Point> curve, double t, int levels, std::span<Point> chain) {
    const std::size_t degree = curve.size() - 1;
    assert(!curve.empty() && levels >= 0 && chain.size() == (degree << levels) + 1);
    const std::vector<Vectors> first = piecesOf(vectorsFromStart(curve), t, std::min(levels, kLaneLevels));
    if (levels <= kLaneLevels) {
        for (std::size_t i = 0; i < first.size(); ++i)
            writePoints(curve.front(), first[i], chain.subspan(i * degree));
    } else {
        LaneSplitter splitter(curve.size(), t, levels - kLaneLevels);
        std::array<Point*, kLanes> chains{};
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            chains[lane] = chain.data() + lane * (degree << (levels - kLaneLevels));
            for (std::size_t i = 0; i <= degree; ++i)
                splitter.set(lane, i, first[lane][i]);
        }
        workByLanes([&]() __attribute__((always_inline)) { splitter.write(curve.front(), chains); });
    }
    chain.back() = curve.back();
}

std::vector<Points> pieces(std::span<const Point> curve, double t, int levels) {
    assert(!curve.empty() && levels >= 0);
    const std::size_t degree = curve.size() - 1;
    Points chain((degree << levels) + 1);
    writePieces(curve, t, levels, chain);
    std::vector<Points> result;
    result.reserve(std::size_t{1} << levels);
    for (std::size_t i = 0; i < std::size_t{1} << levels; ++i)
        result.emplace_back(&chain[i * degree], &chain[i * degree] + curve.size());
    return result;
}

Point blossom(std::span<const Point> curve, std::span<const double> arguments) {
    assert(!curve.empty() && arguments.size() + 1 == curve.size());
    RowBuffer<Vector> buffer(curve.size());
    writeFromStart(curve, buffer.row());
    for (std::size_t i = 0; i < arguments.size(); ++i)
        interpolateRow(buffer.row().first(curve.size() - i), arguments[i]);
    return curve.front() + buffer.row().front();
}

} // namespace kriva
