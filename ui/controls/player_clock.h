#pragma once

namespace kriva::ui {

enum class PlayDirection { forwards, backwards, toAndFro };

inline constexpr double kSlowest = 0.25;
inline constexpr double kFastest = 16;
/// Stages a second at speed 1, unless a player has a pace of its own.
inline constexpr double kStagesPerSecond = 8;

/// Where an animation stands and where its next tick goes: a plain value without time of its own.
struct PlayerClock {
    int stage = 0;
    int last = 0;
    PlayDirection direction = PlayDirection::forwards;
    bool isLooping = true;
    bool isOnWayBack = false; ///< of to and fro
    double pace = kStagesPerSecond;
    double speed = 1; ///< times the pace

    /// Goes one stage on. False where the animation has come to its end and stays.
    bool advance();
    /// To the stage at which playing starts when it stands at its end.
    void rewindAtEnd();
    /// Milliseconds from tick to tick.
    [[nodiscard]] int interval() const { return static_cast<int>(1000 / (pace * speed)); }
};

} // namespace kriva::ui
