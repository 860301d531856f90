#pragma once

#include "core/crossings/arc.h"
#include "core/polynomial/bernstein_polynomial.h"

namespace kriva {

/// Two arcs as graphs over one direction, and the gap y_b(x) - y_a(x) between them.
///
/// Where the second derivatives of the two graphs have no value in common, the gap bends one way throughout: the arcs
/// then meet twice, touch once or do not meet, and which of them it is shows at the one place where they are parallel.
/// That is the second system that tangent curves need, A' x B' = 0 at one x, and it is as well conditioned there as a
/// plain crossing is elsewhere.
class GraphGap {
  public:
    /// Nothing where one of the arcs does not run along the chord of a throughout.
    [[nodiscard]] static std::optional<GraphGap> between(const Arc& a, const Arc& b);

    /// Whether the gap surely bends one way.
    [[nodiscard]] bool bendsOneWay() const;

    /// Where the arcs meet, if the gap bends one way. Where they are parallel and as close as `touching` they meet
    /// once, there.
    [[nodiscard]] std::vector<Contact> contacts(double touching) const;

  private:
    using Coefficients = std::array<double, Arc::kMostDegree + 1>;
    struct Graph {
        std::size_t degree = 0;
        Coefficients x{}; ///< ascending
        Coefficients y{};
        double from = 0;
        double to = 1;
    };
    /// Of the gap at one x; t are the arcs' own parameters.
    struct Value {
        double gap = 0;
        double slope = 0;
        double ta = 0;
        double tb = 0;
    };

    [[nodiscard]] static std::optional<Graph> graphOf(const Arc& arc, Point origin, Vector along);
    [[nodiscard]] static Range bendOf(const Graph& graph);
    [[nodiscard]] static double parameterAt(const Graph& graph, double x);
    [[nodiscard]] Value at(double x) const;
    [[nodiscard]] Contact contactAt(double x) const;
    template <class Measure>
    [[nodiscard]] double zeroBetween(double low, double high, Measure measure) const;

    Graph a_;
    Graph b_;
};

} // namespace kriva
