#include "core/geometry/simplify.h"

#include <algorithm>
#include <cmath>

namespace kriva {

namespace {

/// The directions, from one vertex, of lines that pass all later ones within the tolerance.
class Cone {
  public:
    Cone(Point apex, double tolerance)
        : apex_(apex)
        , tolerance_(tolerance) {}

    /// Whether a line from the apex to p passes all vertices that were added.
    [[nodiscard]] bool contains(Point p) const {
        const Vector v = p - apex_;
        return farthest_ == 0 || (dot(v, v) >= farthest_ && cross(right_, v) >= 0 && cross(v, left_) >= 0);
    }
    void add(Point p) {
        const Vector v = p - apex_;
        const double squared = dot(v, v);
        if (squared <= tolerance_ * tolerance_)
            return; // any line that starts at the apex passes it
        const double along = std::sqrt(squared - tolerance_ * tolerance_);
        const Vector across{-tolerance_ * v.y, tolerance_ * v.x};
        const Vector right = along * v - across;
        const Vector left = along * v + across;
        if (farthest_ == 0 || cross(right_, right) > 0)
            right_ = right;
        if (farthest_ == 0 || cross(left, left_) > 0)
            left_ = left;
        farthest_ = std::max(farthest_, squared);
    }

  private:
    Point apex_;
    double tolerance_;
    double farthest_ = 0; ///< squared distance of a vertex, 0 before the first: no line may end before it
    Vector right_;
    Vector left_;
};

} // namespace

Points simplified(std::span<const Point> polyline, Tolerance tolerance) {
    if (polyline.size() < 3)
        return Points(polyline.begin(), polyline.end());
    Points kept{polyline.front()};
    Cone cone(polyline.front(), tolerance.distance);
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        if (!cone.contains(polyline[i])) {
            kept.push_back(polyline[i - 1]);
            cone = Cone(polyline[i - 1], tolerance.distance);
        }
        cone.add(polyline[i]);
    }
    kept.push_back(polyline.back());
    return kept;
}

} // namespace kriva
