#include "ui/controls/player_clock.h"

#include <gmock/gmock.h>
#include <vector>

namespace kriva::ui {
namespace {

using testing::ElementsAre;

/// The stages of so many ticks, -1 for a tick that finds the animation at its end.
std::vector<int> stages(PlayerClock& clock, int ticks) {
    std::vector<int> passed;
    for (int i = 0; i < ticks; ++i)
        passed.push_back(clock.advance() ? clock.stage : -1);
    return passed;
}

TEST(PlayerClock, forwardsBeginsAnewAfterTheLastStage) {
    PlayerClock clock{1, 3};
    EXPECT_THAT(stages(clock, 6), ElementsAre(2, 3, 0, 1, 2, 3));
}

TEST(PlayerClock, forwardsOnceStaysAtTheLastStage) {
    PlayerClock clock{1, 3, PlayDirection::forwards, false};
    EXPECT_THAT(stages(clock, 4), ElementsAre(2, 3, -1, -1));
    EXPECT_EQ(clock.stage, 3);
    clock.rewindAtEnd();
    EXPECT_EQ(clock.stage, 0);
}

TEST(PlayerClock, backwardsBeginsAnewAtTheLastStage) {
    PlayerClock clock{1, 3, PlayDirection::backwards};
    EXPECT_THAT(stages(clock, 6), ElementsAre(0, 3, 2, 1, 0, 3));
}

TEST(PlayerClock, backwardsOnceStaysAtTheFirstStage) {
    PlayerClock clock{2, 3, PlayDirection::backwards, false};
    EXPECT_THAT(stages(clock, 4), ElementsAre(1, 0, -1, -1));
    EXPECT_EQ(clock.stage, 0);
    clock.rewindAtEnd();
    EXPECT_EQ(clock.stage, 3);
}

TEST(PlayerClock, toAndFroTurnsAtBothEndsAndShowsThemOnce) {
    PlayerClock clock{0, 2, PlayDirection::toAndFro};
    EXPECT_THAT(stages(clock, 9), ElementsAre(1, 2, 1, 0, 1, 2, 1, 0, 1));
}

TEST(PlayerClock, toAndFroOnceEndsWhereItBegan) {
    PlayerClock clock{0, 2, PlayDirection::toAndFro, false};
    EXPECT_THAT(stages(clock, 6), ElementsAre(1, 2, 1, 0, -1, -1));
    clock.rewindAtEnd();
    EXPECT_THAT(stages(clock, 5), ElementsAre(1, 2, 1, 0, -1));
}

TEST(PlayerClock, rewindsOnlyAtItsEnd) {
    for (const PlayDirection direction : {PlayDirection::forwards, PlayDirection::backwards, PlayDirection::toAndFro}) {
        PlayerClock clock{1, 3, direction, false};
        clock.rewindAtEnd();
        EXPECT_EQ(clock.stage, 1);
    }
    PlayerClock back{2, 3, PlayDirection::toAndFro, false, true};
    back.rewindAtEnd();
    EXPECT_TRUE(back.isOnWayBack);
}

TEST(PlayerClock, oneStageIsAlwaysAtItsEnd) {
    for (const bool isLooping : {false, true}) {
        for (const PlayDirection direction :
             {PlayDirection::forwards, PlayDirection::backwards, PlayDirection::toAndFro}) {
            PlayerClock clock{0, 0, direction, isLooping};
            EXPECT_THAT(stages(clock, 3), ElementsAre(-1, -1, -1));
            clock.rewindAtEnd();
            EXPECT_EQ(clock.stage, 0);
        }
    }
}

TEST(PlayerClock, ticksByItsPaceAndSpeed) {
    PlayerClock clock;
    EXPECT_EQ(clock.interval(), 125);
    clock.speed = 0.25;
    EXPECT_EQ(clock.interval(), 500);
    clock.pace = 2;
    EXPECT_EQ(clock.interval(), 2000);
}

} // namespace
} // namespace kriva::ui
