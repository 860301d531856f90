#include "ui/editing/results/coalescing_worker.h"

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
class CoalescingWorkerTest : public testing::Test {
  protected:
    ~CoalescingWorkerTest() override {
        mayEnd.release(100); // whatever still waits
    }

    CoalescingWorker::Work next() {
        return [this, wanted = wanted, steps = steps,
                isEndless = isEndless](WorkBudget& budget) -> CoalescingWorker::Take {
            ++started;
            if (isLong)
                mayEnd.acquire();
            while (isEndless && budget.spend())
                continue;
            (void)budget.spend(steps);
            ended = budget.end();
            ran = QThread::currentThread();
            return [this, wanted] { taken.push_back(wanted); };
        };
    }
    void change(int value) {
        wanted = value;
        worker->doSoon();
    }
    static void turn() { QCoreApplication::processEvents(); }
    void settle() {
        for (int i = 0; i < 3; ++i) {
            turn();
            pool.waitForDone();
        }
        turn();
    }
    /// Until it is worked out on the thread of the window; on a busy machine that may take too long now and then.
    void makeQuick() {
        for (int i = 0; i < 100 && ran != QThread::currentThread(); ++i) {
            change(0);
            settle();
        }
    }

    QThreadPool pool;
    int wanted = 0;
    std::uint64_t steps = 1;
    bool isLong = false;
    bool isEndless = false;
    std::atomic<int> started = 0;
    QSemaphore mayEnd;
    std::vector<int> taken;
    std::optional<WorkEnd> ended;
    QThread* ran = nullptr;
    std::unique_ptr<CoalescingWorker> worker = std::make_unique<CoalescingWorker>(pool, [this] { return next(); });
};

TEST_F(CoalescingWorkerTest, worksOncePerTurnHoweverManyChanges) {
    settle();
    taken.clear();
    for (int i = 1; i <= 50; ++i)
        change(i);
    EXPECT_TRUE(taken.empty());
    settle();
    EXPECT_EQ(taken, std::vector{50});
}

TEST_F(CoalescingWorkerTest, leavesTheThreadOfTheWindowUntilItIsKnownToBeQuick) {
    settle();
    EXPECT_NE(ran, QThread::currentThread());
    makeQuick();
    EXPECT_EQ(ran, QThread::currentThread());
    EXPECT_EQ(taken.back(), wanted);
    worker->startOver();
    settle();
    EXPECT_NE(ran, QThread::currentThread());
}

TEST_F(CoalescingWorkerTest, leavesTheThreadOfTheWindowWhenItIsLongAllOfASudden) {
    makeQuick();
    steps = 1'000'000'000;
    taken.clear();
    change(1);
    settle();
    EXPECT_NE(ran, QThread::currentThread());
    EXPECT_EQ(taken, std::vector{1}) << "taken once, from the other thread";
}

TEST_F(CoalescingWorkerTest, doesNotBlockWhileItTakesLong) {
    isLong = true;
    turn();
    change(1);
    turn(); // would never come back
    EXPECT_TRUE(taken.empty());
    mayEnd.release(2);
    settle();
    EXPECT_EQ(taken, std::vector{1});
}

TEST_F(CoalescingWorkerTest, keepsOutOfTheThreadsThatPaintingWaitsFor) {
    isLong = true;
    turn();
    EXPECT_EQ(pool.activeThreadCount(), 1);
    EXPECT_EQ(QThreadPool::globalInstance()->activeThreadCount(), 0);
}

TEST_F(CoalescingWorkerTest, dropsWhatIsOutOfDate) {
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

TEST_F(CoalescingWorkerTest, aNewerChangeEndsWhatIsWorkedOut) {
    isEndless = true;
    turn();
    change(1);
    isEndless = false;
    settle(); // would never come back
    EXPECT_EQ(taken, std::vector{1});
}

TEST_F(CoalescingWorkerTest, itsOwnEndEndsWhatIsWorkedOut) {
    isEndless = true;
    turn();
    worker.reset();
    pool.waitForDone(); // would never come back
    turn();
    EXPECT_EQ(ended, WorkEnd::stopped);
    EXPECT_TRUE(taken.empty());
}

TEST_F(CoalescingWorkerTest, takesNothingAfterItsEnd) {
    isLong = true;
    turn();
    worker.reset();
    mayEnd.release(10);
    pool.waitForDone();
    turn();
    EXPECT_TRUE(taken.empty());
}

} // namespace
} // namespace kriva::ui
