#include "core/intersections/contacts/graph_gap.h"

#include <cmath>
#include <numeric>

namespace kriva {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();

/// A gap below this may come from rounding: arcs are parts of a figure of about the size 1.
constexpr double kGapNoise = 0x1p-48;

/// Two graphs out of arcs, with the bounds of their bends.
constexpr std::uint64_t kStepsOfGraphs = 32;
/// The gap at one x: a place of each graph by Newton's method.
constexpr std::uint64_t kStepsOfValue = 24;

struct ValueAndSlope {
    double value;
    double slope;
};

ValueAndSlope evaluate(std::array<double, Arc::kMostDegree + 1> row, std::size_t degree, double t) {
    double slope = 0;
    for (std::size_t r = degree; r > 0; --r) {
        if (r == 1)
            slope = static_cast<double>(degree) * (row[1] - row[0]);
        for (std::size_t i = 0; i < r; ++i)
            row[i] = std::lerp(row[i], row[i + 1], t);
    }
    return {row[0], slope};
}

} // namespace

std::optional<GraphGap::Graph> GraphGap::graphOf(const Arc& arc, Point origin, Vector along) {
    Graph graph{arc.degree, {}, {}, arc.from, arc.to};
    for (std::size_t i = 0; i <= arc.degree; ++i) {
        const Vector from = arc.points[i] - origin;
        graph.x[i] = dot(along, from);
        graph.y[i] = cross(along, from);
        if (i > 0 && !(graph.x[i] > graph.x[i - 1]))
            return {};
    }
    return graph;
}

std::optional<GraphGap> GraphGap::between(const Arc& a, const Arc& b, WorkBudget& budget) {
    if (!budget.spend(kStepsOfGraphs))
        return {};
    const double chord = length(a.chord());
    if (chord == 0)
        return {};
    const Vector along = a.chord() / chord;
    GraphGap gap;
    const auto one = graphOf(a, a.front(), along);
    if (!one)
        return {};
    const auto other = graphOf(dot(along, b.chord()) < 0 ? reversed(b) : b, a.front(), along);
    if (!other)
        return {};
    gap.a_ = *one;
    gap.b_ = *other;
    gap.xs_ = {std::max(one->x[0], other->x[0]), std::min(one->x[one->degree], other->x[other->degree])};
    const Range bendA = bendOf(*one), bendB = bendOf(*other);
    gap.bend_ = {bendB.low - bendA.high, bendB.high - bendA.low};
    gap.middle_ = gap.at(gap.xs_.low / 2 + gap.xs_.high / 2);
    return gap;
}

/// Bounds of the second derivative of the graph: (x' y'' - y' x'') / x'^3 by the control values of both factors.
Range GraphGap::bendOf(const Graph& graph) {
    const std::size_t n = graph.degree;
    if (n < 2)
        return {};
    double fewest = std::numeric_limits<double>::infinity(), most = 0;
    Range turning{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < n; ++i) {
        const Vector side{graph.x[i + 1] - graph.x[i], graph.y[i + 1] - graph.y[i]};
        fewest = std::min(fewest, side.x);
        most = std::max(most, side.x);
        for (std::size_t j = 0; j + 2 <= n; ++j) {
            const Vector turn{graph.x[j + 2] - 2 * graph.x[j + 1] + graph.x[j],
                              graph.y[j + 2] - 2 * graph.y[j + 1] + graph.y[j]};
            const double product = cross(side, turn);
            turning.low = std::min(turning.low, product);
            turning.high = std::max(turning.high, product);
        }
    }
    const double factor = static_cast<double>(n - 1) / static_cast<double>(n);
    const double nearest = fewest * fewest * fewest / factor;
    const double farthest = most * most * most / factor;
    return {turning.low / (turning.low < 0 ? nearest : farthest),
            turning.high / (turning.high > 0 ? nearest : farthest)};
}

/// Newton's method within a bracket: x rises throughout.
double GraphGap::parameterAt(const Graph& graph, double x) {
    const double first = graph.x[0], last = graph.x[graph.degree];
    if (x <= first)
        return 0;
    if (x >= last)
        return 1;
    double low = 0, high = 1;
    double t = (x - first) / (last - first);
    for (int step = 0; step < 60; ++step) {
        const auto [value, slope] = evaluate(graph.x, graph.degree, t);
        (value < x ? low : high) = t;
        double next = t - (value - x) / slope;
        if (!(next > low && next < high))
            next = low / 2 + high / 2;
        if (std::abs(next - t) <= kRounding * next)
            return next;
        t = next;
    }
    return t;
}

GraphGap::Value GraphGap::at(double x) const {
    Value value;
    value.ta = parameterAt(a_, x);
    value.tb = parameterAt(b_, x);
    const auto ya = evaluate(a_.y, a_.degree, value.ta), yb = evaluate(b_.y, b_.degree, value.tb);
    const auto xa = evaluate(a_.x, a_.degree, value.ta), xb = evaluate(b_.x, b_.degree, value.tb);
    value.gap = yb.value - ya.value;
    value.slope = yb.slope / xb.slope - ya.slope / xa.slope;
    return value;
}

Contact GraphGap::contactAt(double x) const {
    return {a_.from + parameterAt(a_, x) * (a_.to - a_.from), b_.from + parameterAt(b_, x) * (b_.to - b_.from)};
}

/// Where a measure of the gap that differs in sign at both places vanishes: the secant of Illinois, every third step a
/// halving.
template <class Measure>
double GraphGap::zeroBetween(double low, double high, WorkBudget& budget, Measure measure) const {
    double atLow = measure(at(low)), atHigh = measure(at(high));
    int kept = 0;
    for (int step = 0; step < 120 && high - low > kRounding * (std::abs(low) + std::abs(high)); ++step) {
        double x = low - atLow * (high - low) / (atHigh - atLow);
        if (step % 3 == 2 || !(x > low && x < high))
            x = low / 2 + high / 2;
        if (x <= low || x >= high)
            break;
        const double value = measure(at(x));
        if (value == 0 || !budget.spend(kStepsOfValue))
            return x;
        const int side = (value > 0) == (atHigh > 0) ? 1 : -1;
        (side > 0 ? high : low) = x;
        (side > 0 ? atHigh : atLow) = value;
        if (kept == side)
            (side > 0 ? atLow : atHigh) /= 2;
        kept = side;
    }
    return low / 2 + high / 2;
}

double GraphGap::deviation() const {
    const double half = (xs_.high - xs_.low) / 2;
    return half * (std::abs(middle_.slope) + half / 2 * std::max(-bend_.low, bend_.high));
}

bool GraphGap::isWithin(double distance) const {
    return xs_.low <= xs_.high && std::abs(middle_.gap) + deviation() <= distance;
}

std::optional<std::vector<Contact>> GraphGap::contacts(double touching, WorkBudget& budget) const {
    if (xs_.low > xs_.high || std::abs(middle_.gap) > touching + deviation())
        return std::vector<Contact>();
    if (bend_.low > 0)
        return contactsOfConvex(1, touching, budget);
    if (bend_.high < 0)
        return contactsOfConvex(-1, touching, budget);
    const double half = (xs_.high - xs_.low) / 2;
    const double steepest = std::abs(middle_.slope) - half * std::max(-bend_.low, bend_.high);
    if (half * steepest > kGapNoise)
        return contactsOfSteep(touching * kOn, budget);
    return {};
}

/// The gap rises or falls throughout.
std::vector<Contact> GraphGap::contactsOfSteep(double noise, WorkBudget& budget) const {
    const double first = at(xs_.low).gap, last = at(xs_.high).gap;
    if (std::abs(first) <= noise)
        return {contactAt(xs_.low)};
    if (std::abs(last) <= noise)
        return {contactAt(xs_.high)};
    if ((first > 0) == (last > 0))
        return {};
    return {contactAt(zeroBetween(xs_.low, xs_.high, budget, [](const Value& value) { return value.gap; }))};
}

/// The gap, times the sign, bends upwards throughout.
std::vector<Contact> GraphGap::contactsOfConvex(double sign, double touching, WorkBudget& budget) const {
    const auto [low, high] = xs_;
    const auto gap = [sign](const Value& value) { return sign * value.gap; };
    const auto slope = [sign](const Value& value) { return sign * value.slope; };
    // Where arcs meet just at their ends, rounding must not take the place from this arc and its neighbour both.
    const double noise = touching * kOn;
    const Value first = at(low), last = at(high);
    const double lowest = slope(first) >= 0 ? low : slope(last) <= 0 ? high : zeroBetween(low, high, budget, slope);
    const double least = gap(at(lowest));
    if (lowest > low && lowest < high && std::abs(least) <= touching)
        return {contactAt(lowest)};
    if (std::abs(least) <= noise)
        return {contactAt(lowest)};
    if (least > 0)
        return {};
    std::vector<Contact> found;
    if (gap(first) > -noise && lowest > low)
        found.push_back(gap(first) <= 0 ? contactAt(low) : contactAt(zeroBetween(low, lowest, budget, gap)));
    if (gap(last) > -noise && lowest < high)
        found.push_back(gap(last) <= 0 ? contactAt(high) : contactAt(zeroBetween(lowest, high, budget, gap)));
    return found;
}

} // namespace kriva
