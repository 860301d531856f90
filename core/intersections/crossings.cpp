#include "core/intersections/crossings.h"

#include "core/bezier/bounds.h"
#include "core/bezier/evaluate.h"
#include "core/bezier/measures/curvature.h"
#include "core/intersections/chain_links.h"
#include "core/intersections/loops/double_points.h"
#include "core/intersections/places.h"
#include "core/intersections/sweep.h"
#include "core/polynomial/sign_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace kriva {
namespace {

/// Of the diagonal: format.md.
constexpr double kTouching = 1e-12;
constexpr double kPlace = 1e-9;

/// A segment put into the frame, its bounds and its cusps.
constexpr std::uint64_t kStepsOfSegment = 80;

/// A straight segment turns back if the way it goes back is longer than this part of its polygon's length.
constexpr double kTurningBack = 1e-9;

bool turnsBackOnItself(std::span<const Point> segment) {
    if (!isStraight(segment))
        return false;
    const auto fromFront = [&](Point p) { return distance(p, segment.front()); };
    const Vector along = *std::ranges::max_element(segment, {}, fromFront) - segment.front();
    const auto reached = [&](double t) { return dot(along / length(along), evaluate(segment, t) - segment.front()); };
    std::vector<double> speeds;
    for (const Vector velocity : hodograph(segment))
        speeds.push_back(dot(along, velocity));
    std::vector<double> turns = signChanges(speeds);
    turns.push_back(1);
    double way = 0, from = 0;
    for (const double t : turns) {
        way += std::abs(reached(t) - reached(from));
        from = t;
    }
    return way - std::abs(reached(1)) > kTurningBack * polygonLength(segment);
}

/// A segment that takes part.
struct Member {
    std::size_t curve;
    std::size_t segment;
    CuspedArc arc;
    std::optional<std::size_t> follower;
};

class Search {
  public:
    Search(std::span<const SegmentChain> chains, WorkBudget& budget, std::size_t mostPasses)
        : chains_(chains)
        , budget_(budget)
        , mostPasses_(mostPasses) {
        Box bounds;
        for (const SegmentChain& chain : chains)
            for (const Points& segment : chain.segments) {
                if (!budget.spend(kStepsOfSegment))
                    return;
                bounds = united(bounds, tightBounds(segment));
            }
        diagonal_ = diagonal(bounds);
        if (!(diagonal_ > 0))
            return;
        // Coordinates far from the origin are given to one unit in their last place only.
        const double largest =
            std::max({std::abs(bounds.xmin), std::abs(bounds.xmax), std::abs(bounds.ymin), std::abs(bounds.ymax)});
        const double touching = kTouching * diagonal_ + largest * std::numeric_limits<double>::epsilon();
        frame_ = {bounds.centre(), std::exp2(std::floor(std::log2(diagonal_)))};
        scale_ = {touching / frame_.unit, std::max(kPlace * diagonal_, 4 * touching) / frame_.unit};
        for (std::size_t i = 0; i < chains.size() && !budget.end(); ++i)
            addMembers(i);
    }

    [[nodiscard]] Crossings find() {
        if (members_.empty())
            return {};
        std::vector<Box> boxes;
        for (const Member& member : members_) {
            if (budget_.end())
                return {};
            addDoublePoints(member);
            boxes.push_back(grown(member.arc.arc.box, scale_.touching));
        }
        forEachOverlap(boxes, budget_, [this](std::size_t i, std::size_t j) { addContacts(members_[i], members_[j]); });
        if (budget_.end())
            return {};
        std::ranges::sort(overlaps_, {}, [](const Overlap& overlap) {
            const auto& [one, other] = overlap.passes;
            return std::tuple(one.curve, one.segment, other.curve, other.segment, one.from, other.from);
        });
        Crossings found{unitedPlaces(chains_, meetings_, scale_.place * frame_.unit, budget_), std::move(overlaps_)};
        std::size_t passes = 2 * found.overlaps.size();
        for (const Crossing& place : found.places)
            passes += place.passes.size();
        if (passes > mostPasses_)
            budget_.endFor(WorkEnd::tooMuchFound);
        return found;
    }

  private:
    void addMembers(std::size_t curve) {
        const SegmentChain& chain = chains_[curve];
        const auto after = followers(chain);
        for (std::size_t i = 0; i < chain.segments.size(); ++i) {
            if (!budget_.spend(kStepsOfSegment))
                return;
            const Points& segment = chain.segments[i];
            if (!isOnePoint(segment) && !turnsBackOnItself(segment))
                members_.push_back({curve, i, cuspedArcOf(segment, frame_), after[i]});
        }
    }

    void addDoublePoints(const Member& member) {
        // The only segment of a closed chain ends at the knot where it starts.
        const bool isRing = member.follower == member.segment;
        SegmentContacts found = doublePoints(member.arc.arc, scale_, budget_);
        if (isRing)
            std::erase(found.contacts, Contact{0, 1});
        add(member, member, found);
    }

    void addContacts(const Member& one, const Member& other) {
        std::vector<Contact> joints;
        if (one.curve == other.curve && one.follower == other.segment)
            joints.push_back({1, 0});
        if (one.curve == other.curve && other.follower == one.segment)
            joints.push_back({0, 1});
        add(one, other, contactsOf(one.arc, other.arc, joints, scale_, budget_));
    }

    void add(const Member& one, const Member& other, const SegmentContacts& found) {
        for (const auto [t, s] : found.contacts)
            meetings_.push_back({{one.curve, one.segment, t}, {other.curve, other.segment, s}});
        for (const auto& [from, to] : found.common)
            overlaps_.push_back(
                {{{{one.curve, one.segment, from.a, to.a}, {other.curve, other.segment, from.b, to.b}}}});
        if (2 * overlaps_.size() > mostPasses_) // of meetings several may turn out as one place
            budget_.endFor(WorkEnd::tooMuchFound);
    }

    std::span<const SegmentChain> chains_;
    WorkBudget& budget_;
    std::size_t mostPasses_;
    double diagonal_ = 0;
    ArcFrame frame_;
    ContactScale scale_;
    std::vector<Member> members_;
    std::vector<Meeting> meetings_;
    std::vector<Overlap> overlaps_;
};

} // namespace

std::optional<Crossings> findCrossings(std::span<const SegmentChain> chains, WorkBudget& budget,
                                       std::size_t mostPasses) {
    Crossings found = Search(chains, budget, mostPasses).find();
    if (budget.end())
        return {};
    return found;
}

Crossings findCrossings(std::span<const SegmentChain> chains) {
    return withoutLimit(
        [&](WorkBudget& budget) { return findCrossings(chains, budget, std::numeric_limits<std::size_t>::max()); });
}

} // namespace kriva
