#pragma once

#include "core/figure/figure.h"
#include "core/figure/style/page.h"

namespace kriva {

/// What a label should not cover, on a page in millimetres.
class Obstacles {
  public:
    void addLine(Point from, Point to, double weight) { lines_.push_back({from, to, weight}); }
    void addMark(Point at) { marks_.push_back(at); }
    void addText(const Box& box) { texts_.push_back(box); }

    /// How bad it is to cover what lies in the box: millimetres of line by their weights, marks and texts for more.
    [[nodiscard]] double covered(const Box& box) const;

  private:
    struct Line {
        Point from;
        Point to;
        double weight = 1;
    };
    std::vector<Line> lines_;
    Points marks_;
    std::vector<Box> texts_;
};

/// The strokes and marks of a figure, curves as chords; those beyond the first few ten thousand are left out.
[[nodiscard]] Obstacles obstaclesOf(const Figure& figure, const Page& page);

/// The length of the part of the segment that lies in the box.
[[nodiscard]] double lengthInside(const Box& box, Point from, Point to);

} // namespace kriva
