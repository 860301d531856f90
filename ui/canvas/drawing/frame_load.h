#pragma once

#include <algorithm>
#include <cstddef>

namespace kriva::ui {

/// How finely a frame is drawn. What is beyond the eye is left out first, what only makes a blot darker last.
struct Fineness {
    double tolerance = 0.1; ///< pixels between a path and its chords
    double spacing = 0.25;  ///< pixels; points closer than this to the one before are left out
    int markSpacing = 1;    ///< device pixels; of marks in the same square of this side one stands for all
    int share = 1;          ///< one in so many runs of pieces is drawn

    friend bool operator==(const Fineness&, const Fineness&) = default;
};

/// What there is to paint in a frame. Whoever prepares a part of it adds to it while working, and may stop when it is
/// too much: then everything is prepared anew, coarser.
struct FrameLoad {
    double points = 0;      ///< of polylines
    double ink = 0;         ///< pixels touched by lines
    double marks = 0;       ///< of any kind
    std::size_t pieces = 0; ///< looked at so far; the share that is drawn is counted through all paths

    FrameLoad& operator+=(const FrameLoad& other) {
        points += other.points;
        ink += other.ink;
        marks += other.marks;
        return *this;
    }
    friend FrameLoad operator-(FrameLoad a, const FrameLoad& b) {
        a.points -= b.points;
        a.ink -= b.ink;
        a.marks -= b.marks;
        return a;
    }
    /// As a part of what can be painted while a hand drags.
    [[nodiscard]] double part() const { return std::max({points / kPoints, ink / kInk, marks / kMarks}); }
    [[nodiscard]] bool isTooMuch() const { return points > kPoints || ink > kInk || marks > kMarks; }

    static constexpr double kPoints = 5'000;
    static constexpr double kInk = 1'500'000;
    static constexpr double kMarks = 6'000;
};

/// Less of what is too much, by `factor`; the same where nothing is left to leave out.
[[nodiscard]] inline Fineness coarser(Fineness fineness, const FrameLoad& load, int factor) {
    constexpr double kWidestSpacing = 8;
    constexpr int kWidestMarkSpacing = 4096; // a mark of a kind for each curve: their lines are worth more
    constexpr int kLeastShare = 4096;
    if (load.marks > FrameLoad::kMarks && fineness.markSpacing < kWidestMarkSpacing)
        fineness.markSpacing *= factor;
    else if (load.points > FrameLoad::kPoints && load.ink <= FrameLoad::kInk && fineness.spacing < kWidestSpacing)
        fineness.spacing *= factor;
    else if (fineness.share < kLeastShare)
        fineness.share *= factor;
    return fineness;
}

/// Twice as much again, of what was left out last.
[[nodiscard]] inline Fineness finer(Fineness fineness) {
    if (fineness.share > 1)
        fineness.share /= 2;
    else if (fineness.spacing > Fineness().spacing)
        fineness.spacing /= 2;
    else if (fineness.markSpacing > 1)
        fineness.markSpacing /= 2;
    return fineness;
}

} // namespace kriva::ui
