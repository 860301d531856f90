#pragma once

#include "core/budget/work_budget.h"
#include "core/intersections/contacts/arc.h"
#include "core/polynomial/bernstein_polynomial.h"

namespace kriva {

/// Two arcs as graphs over one direction, and the gap y_b(x) - y_a(x) between them.
///
/// Bounds of the second derivatives of both graphs bound how the gap bends. Where it bends one way throughout, the arcs
/// meet twice, touch once or do not meet, and which of them it is shows at the one place where they are parallel: the
/// second system that tangent curves need, A' x B' = 0 at one x, as well conditioned there as a plain crossing is
/// elsewhere. Where it bends too little to turn or to close from what it is in the middle, they meet once at most or do
/// not meet: that tells arcs apart that run beside each other, with an error of third order in their length.
class GraphGap {
  public:
    /// Nothing where one of the arcs does not run along the chord of a throughout.
    [[nodiscard]] static std::optional<GraphGap> between(const Arc& a, const Arc& b, WorkBudget& budget);

    /// Where the arcs meet, if the bounds tell. Where they are parallel and as close as `touching` they meet once,
    /// there.
    [[nodiscard]] std::optional<std::vector<Contact>> contacts(double touching, WorkBudget& budget) const;

    /// Whether the arcs surely stay within the distance of each other all along.
    [[nodiscard]] bool isWithin(double distance) const;

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
    /// How far the gap may be from that in the middle.
    [[nodiscard]] double deviation() const;
    [[nodiscard]] std::vector<Contact> contactsOfConvex(double sign, double touching, WorkBudget& budget) const;
    [[nodiscard]] std::vector<Contact> contactsOfSteep(double noise, WorkBudget& budget) const;
    template <class Measure>
    [[nodiscard]] double zeroBetween(double low, double high, WorkBudget& budget, Measure measure) const;

    Graph a_;
    Graph b_;
    Range xs_;     ///< where both are
    Range bend_;   ///< of the gap
    Value middle_; ///< in the middle of both
};

} // namespace kriva
