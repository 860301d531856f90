#pragma once

#include "core/figure/figure.h"
#include "core/io/svg/paths/elliptical_arc.h"

namespace kriva {

/// Gathers what the commands of path data draw, a path for each subpath. Those that draw nothing are left out.
class Subpaths {
  public:
    void moveTo(Point to);
    void lineTo(Point to) { add({to}); }
    void quadraticTo(Point control, Point to) { add({control, to}); }
    void cubicTo(Point first, Point second, Point to) { add({first, second, to}); }
    /// A line where it is one.
    void arcTo(const EllipticalArc& arc, Point to);
    /// Goes back to where the subpath began, by a line where it is not there already.
    void close();

    /// Where the next piece begins.
    [[nodiscard]] Point at() const { return at_; }
    /// How many there are, of all subpaths.
    [[nodiscard]] std::size_t pieces() const { return pieces_; }
    [[nodiscard]] std::vector<Path> take() &&;

  private:
    void add(std::initializer_list<Point> further);
    void finish();

    std::vector<Path> done_;
    Path open_;
    Point start_;
    Point at_;
    std::size_t pieces_ = 0;
};

} // namespace kriva
