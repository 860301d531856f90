#pragma once

namespace kriva::ui {

enum class PlayDirection { forwards, backwards, toAndFro };

/// Where an animation stands and where its next tick goes: a plain value without time of its own.
struct PlayerClock {
    int stage = 0;
    int last = 0;
    PlayDirection direction = PlayDirection::forwards;
    bool isLooping = true;
    bool isOnWayBack = false; ///< of to and fro

    /// Goes one stage on. False where the animation has come to its end and stays.
    bool advance();
    /// To the stage at which playing starts when it stands at its end.
    void rewindAtEnd();
};

inline constexpr double kSlowest = 0.25;
inline constexpr double kFastest = 16;
/// Stages a second at speed 1, unless a player has a pace of its own.
inline constexpr double kStagesPerSecond = 8;

} // namespace kriva::ui
