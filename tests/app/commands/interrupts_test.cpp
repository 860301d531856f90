#include "app/commands/interrupts.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <unistd.h>

namespace kriva::app {
namespace {

/// Each in a process of its own, begun anew: threads do not survive a fork.
class Interrupted : public testing::Test {
  protected:
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(Interrupted, endsByTheSignalItself) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_EXIT(
            {
                const Interrupts interrupts;
                (void)std::raise(number);
                std::fputs("went on", stderr);
                std::_Exit(0);
            },
            testing::KilledBySignal(number), "^$");
}

TEST_F(Interrupted, endsAWriteFirst) {
    EXPECT_EXIT(
        {
            const Interrupts interrupts;
            {
                const Uninterrupted untilWritten;
                (void)std::raise(SIGTERM);
                std::fputs("written", stderr);
            }
            std::fputs(" and went on", stderr);
            std::_Exit(0);
        },
        testing::KilledBySignal(SIGTERM), "^written$");
}

TEST_F(Interrupted, leavesIgnoredWhatWasIgnored) {
    EXPECT_EXIT(
        {
            (void)std::signal(SIGHUP, SIG_IGN);
            const Interrupts interrupts;
            (void)std::raise(SIGHUP);
            std::_Exit(7);
        },
        testing::ExitedWithCode(7), "^$");
}

TEST_F(Interrupted, givesBackWhatWasThere) {
    const auto before = std::signal(SIGTERM, SIG_IGN);
    { const Interrupts interrupts; }
    EXPECT_EQ(std::signal(SIGTERM, before), SIG_IGN);
}

} // namespace
} // namespace kriva::app
