#include "core/intersections/places.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "core/geometry/box.h"
#include "core/intersections/chain_links.h"
#include "core/intersections/place_grid.h"

#include <algorithm>

namespace kriva {
namespace {

/// A parameter this close to an end is the end: a tenth of what passes are told to.
constexpr double kEndNoise = 1e-8;

/// Passes that are put in order and grouped.
constexpr std::uint64_t kStepsOfMeeting = 20;

/// Meetings whose distances are compared within one step.
constexpr std::size_t kComparedMeetings = 16;

/// A part of what is certain, whatever rounding does.
constexpr double kSurely = 0.999;

class Places {
  public:
    Places(std::span<const SegmentChain> chains, std::span<const Meeting> meetings, double distance, WorkBudget& budget)
        : chains_(chains)
        , meetings_(meetings)
        , distance_(distance)
        , budget_(budget) {
        for (const SegmentChain& chain : chains)
            followers_.push_back(followers(chain));
        if (budget.spend(kStepsOfMeeting * meetings.size()))
            for (const Meeting& meeting : meetings)
                at_.push_back(pointAt(meeting.one));
    }

    [[nodiscard]] std::vector<Crossing> united() const {
        std::vector<Crossing> places;
        if (budget_.end())
            return places;
        for (const std::vector<std::size_t>& cluster : clusters()) {
            if (!budget_.spend(kStepsOfMeeting * cluster.size())) // of the meetings in it
                break;
            Crossing place{{}, passesOf(cluster)};
            if (place.passes.size() < 2)
                continue;
            place.at = pointAt(place.passes.front());
            places.push_back(std::move(place));
        }
        std::ranges::sort(places, {}, &Crossing::passes);
        return places;
    }

  private:
    /// One end of a meeting.
    struct Entry {
        Pass pass;
        std::size_t meeting;
    };

    [[nodiscard]] const Points& segmentOf(const Pass& pass) const { return chains_[pass.curve].segments[pass.segment]; }
    [[nodiscard]] Point pointAt(const Pass& pass) const { return evaluate(segmentOf(pass), pass.t); }

    /// Meetings by index, those of one place together.
    [[nodiscard]] std::vector<std::vector<std::size_t>> clusters() const {
        const PlaceGrid grid(at_, distance_);
        Clusters clusters(at_.size());
        for (std::size_t cell = 0; cell < grid.cells().size(); ++cell) {
            // Those of one cell are closer than the distance.
            const std::span<const std::size_t> own = grid.indicesIn(cell);
            for (const std::size_t i : own)
                clusters.unite(own.front(), i);
            grid.forEachNeighbour(cell, [&](std::span<const std::size_t> others) { uniteNear(clusters, own, others); });
        }
        return clusters.take();
    }

    /// Unites two cells, of which each is one cluster, if any two of them are close enough.
    void uniteNear(Clusters& clusters, std::span<const std::size_t> own, std::span<const std::size_t> others) const {
        if (clusters.areOne(own.front(), others.front()))
            return;
        for (const std::size_t i : own) {
            if (!budget_.spend(1 + others.size() / kComparedMeetings))
                return;
            for (const std::size_t j : others)
                if (kriva::distance(at_[i], at_[j]) <= distance_)
                    return clusters.unite(i, j);
        }
    }

    /// A pass through a knot as the start of the segment after it.
    [[nodiscard]] Pass atKnot(Pass pass) const {
        const Points& segment = segmentOf(pass);
        if (pass.t <= kEndNoise || (pass.t < 0.5 && isWithin(segment, 0, pass.t, distance_ / 1000)))
            return {pass.curve, pass.segment, 0};
        if (pass.t < 1 - kEndNoise && (pass.t < 0.5 || !isWithin(segment, pass.t, 1, distance_ / 1000)))
            return pass;
        if (const auto next = followers_[pass.curve][pass.segment])
            return {pass.curve, *next, 0};
        return {pass.curve, pass.segment, 1};
    }

    [[nodiscard]] static bool isWithin(const Points& segment, double from, double to, double size) {
        if (from == to)
            return true;
        // Most questions are answered by the ends of the part or by its polygon's longest possible side.
        double longest = 0;
        for (std::size_t i = 1; i < segment.size(); ++i)
            longest = std::max(longest, kriva::distance(segment[i - 1], segment[i]));
        if (static_cast<double>(segment.size() - 1) * longest * (to - from) <= kSurely * size)
            return true;
        if (kSurely * kriva::distance(evaluate(segment, from), evaluate(segment, to)) > size)
            return false;
        return diagonal(boxOf(part(segment, from, to))) <= size;
    }

    /// Whether the curve runs from one pass to a later one without leaving the place.
    [[nodiscard]] bool runInto(const Pass& one, const Pass& other) const {
        const double size = 4 * distance_;
        if (one.curve != other.curve)
            return false;
        if (one.segment == other.segment && one.t <= other.t)
            return isWithin(segmentOf(one), one.t, other.t, size);
        return followers_[one.curve][one.segment] == other.segment && isWithin(segmentOf(one), one.t, 1, size) &&
               isWithin(segmentOf(other), 0, other.t, size);
    }

    [[nodiscard]] bool isLoop(std::size_t meeting) const {
        const auto& [one, other] = meetings_[meeting];
        return one.curve == other.curve && one.segment == other.segment;
    }

    [[nodiscard]] std::vector<Pass> passesOf(std::span<const std::size_t> cluster) const {
        std::vector<Entry> entries;
        for (const std::size_t i : cluster) {
            entries.push_back({atKnot(meetings_[i].one), i});
            entries.push_back({atKnot(meetings_[i].other), i});
        }
        std::ranges::sort(entries, {}, &Entry::pass);
        std::vector<std::vector<Entry>> groups;
        const auto isPartner = [this](const std::vector<Entry>& group, const Entry& entry) {
            return isLoop(entry.meeting) && std::ranges::any_of(group, [&](const Entry& other) {
                       return other.meeting == entry.meeting && other.pass != entry.pass;
                   });
        };
        for (const Entry& entry : entries) {
            if (!groups.empty() && runInto(groups.back().back().pass, entry.pass) && !isPartner(groups.back(), entry))
                groups.back().push_back(entry);
            else
                groups.push_back({entry});
        }
        joinAround(groups);
        std::vector<Pass> passes;
        for (const std::vector<Entry>& group : groups) {
            const auto atStart = std::ranges::find(group, 0.0, [](const Entry& entry) { return entry.pass.t; });
            passes.push_back(atStart != group.end() ? atStart->pass : group.front().pass);
        }
        std::ranges::sort(passes);
        return passes;
    }

    /// A closed curve may run from its last pass through the place into its first one.
    void joinAround(std::vector<std::vector<Entry>>& groups) const {
        for (std::size_t first = 0; first < groups.size(); ++first) {
            std::size_t last = first;
            while (last + 1 < groups.size() && groups[last + 1][0].pass.curve == groups[first][0].pass.curve)
                ++last;
            if (last > first && runInto(groups[last].back().pass, groups[first].front().pass)) {
                groups[first].insert(groups[first].end(), groups[last].begin(), groups[last].end());
                groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(last));
                --last;
            }
            first = last;
        }
    }

    std::span<const SegmentChain> chains_;
    std::span<const Meeting> meetings_;
    double distance_;
    WorkBudget& budget_;
    std::vector<std::vector<std::optional<std::size_t>>> followers_;
    std::vector<Point> at_; ///< of the meetings
};

} // namespace

std::vector<Crossing> unitedPlaces(std::span<const SegmentChain> chains, std::span<const Meeting> meetings,
                                   double distance, WorkBudget& budget) {
    return Places(chains, meetings, distance, budget).united();
}

} // namespace kriva
