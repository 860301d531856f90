#include "ui/sheets/results/latest_work.h"

#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QSemaphore>
#include <QThread>
#include <QThreadPool>

#include <atomic>
#include <memory>
#include <vector>

namespace kriva::ui {
namespace {

/// What was asked for at the time is what is taken.
class LatestWorkTest : public testing::Test {
  protected:
    LatestWork::Work next() {
        return [this, wanted = wanted]() -> LatestWork::Take {
            ++started;
            if (isLong)
                mayEnd.acquire();
            ran = QThread::currentThread();
            return [this, wanted] { taken.push_back(wanted); };
        };
    }
    void change(int value) {
        wanted = value;
        work->doSoon();
    }
    static void turn() { QCoreApplication::processEvents(); }
    static void settle() {
        for (int i = 0; i < 3; ++i) {
            turn();
            QThreadPool::globalInstance()->waitForDone();
        }
        turn();
    }

    int wanted = 0;
    bool isLong = false;
    std::atomic<int> started = 0;
    QSemaphore mayEnd;
    std::vector<int> taken;
    QThread* ran = nullptr;
    std::unique_ptr<LatestWork> work = std::make_unique<LatestWork>([this] { return next(); });
};

TEST_F(LatestWorkTest, isDoneOncePerTurnHoweverManyChanges) {
    settle();
    taken.clear();
    for (int i = 1; i <= 50; ++i)
        change(i);
    EXPECT_TRUE(taken.empty());
    settle();
    EXPECT_EQ(taken, std::vector{50});
}

TEST_F(LatestWorkTest, leavesTheThreadOfTheWindowUntilItIsKnownToBeQuick) {
    settle();
    EXPECT_NE(ran, QThread::currentThread());
    // On a busy machine even this may take too long now and then.
    for (int i = 1; i <= 100 && ran != QThread::currentThread(); ++i) {
        change(i);
        settle();
    }
    EXPECT_EQ(ran, QThread::currentThread());
    EXPECT_EQ(taken.back(), wanted);
    work->startOver();
    settle();
    EXPECT_NE(ran, QThread::currentThread());
}

TEST_F(LatestWorkTest, doesNotBlockWhileItTakesLong) {
    isLong = true;
    turn();
    change(1);
    turn(); // would never come back
    EXPECT_TRUE(taken.empty());
    mayEnd.release(2);
    settle();
    EXPECT_EQ(taken, std::vector{1});
}

TEST_F(LatestWorkTest, dropsWhatIsOutOfDate) {
    isLong = true;
    turn();
    for (int i = 1; i <= 5; ++i) {
        change(i);
        turn();
    }
    mayEnd.release(10);
    settle();
    EXPECT_EQ(taken, std::vector{5});
    EXPECT_EQ(started, 2); // one at a time: those between were never begun
}

TEST_F(LatestWorkTest, takesNothingAfterItsEnd) {
    isLong = true;
    turn();
    work.reset();
    mayEnd.release(10);
    settle();
    EXPECT_TRUE(taken.empty());
}

} // namespace
} // namespace kriva::ui
