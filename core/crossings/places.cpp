#include "core/crossings/places.h"

#include "core/bezier/evaluate.h"
#include "core/bezier/subdivide.h"
#include "core/crossings/chain_links.h"
#include "core/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kriva {
namespace {

/// A parameter this close to an end is the end: a tenth of what passes are told to.
constexpr double kEndNoise = 1e-8;

class Places {
  public:
    Places(std::span<const SegmentChain> chains, std::span<const Meeting> meetings, double distance)
        : chains_(chains)
        , meetings_(meetings)
        , distance_(distance) {
        for (const SegmentChain& chain : chains)
            followers_.push_back(followers(chain));
        for (const Meeting& meeting : meetings)
            at_.push_back(pointAt(meeting.one));
    }

    [[nodiscard]] std::vector<Crossing> united() const {
        std::vector<Crossing> places;
        for (const std::vector<std::size_t>& cluster : clusters()) {
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

    /// Meetings by index, those of one place together. Places are found in columns as wide as the distance.
    [[nodiscard]] std::vector<std::vector<std::size_t>> clusters() const {
        std::vector<std::size_t> order(meetings_.size()), root(meetings_.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::iota(root.begin(), root.end(), std::size_t(0));
        const auto key = [&](std::size_t i) { return std::pair(std::floor(at_[i].x / distance_), at_[i].y); };
        std::ranges::sort(order, {}, key);
        const auto rootOf = [&root](std::size_t i) {
            while (root[i] != i)
                i = root[i] = root[root[i]];
            return i;
        };
        for (std::size_t k = 0; k < order.size(); ++k) {
            const std::size_t i = order[k];
            const auto uniteFrom = [&](auto first, double column) {
                for (; first != order.end() && key(*first) <= std::pair(column, at_[i].y + distance_); ++first)
                    if (kriva::distance(at_[i], at_[*first]) <= distance_)
                        root[rootOf(*first)] = rootOf(i);
            };
            const double column = key(i).first;
            uniteFrom(order.begin() + static_cast<std::ptrdiff_t>(k) + 1, column);
            uniteFrom(std::ranges::lower_bound(order, std::pair(column + 1, at_[i].y - distance_), {}, key),
                      column + 1);
        }
        std::vector<std::vector<std::size_t>> byRoot(meetings_.size());
        for (std::size_t i = 0; i < meetings_.size(); ++i)
            byRoot[rootOf(i)].push_back(i);
        std::erase_if(byRoot, [](const auto& cluster) { return cluster.empty(); });
        return byRoot;
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
        return from == to || diagonal(boxOf(part(segment, from, to))) <= size;
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
    std::vector<std::vector<std::optional<std::size_t>>> followers_;
    std::vector<Point> at_; ///< of the meetings
};

} // namespace

std::vector<Crossing> unitedPlaces(std::span<const SegmentChain> chains, std::span<const Meeting> meetings,
                                   double distance) {
    return Places(chains, meetings, distance).united();
}

} // namespace kriva
