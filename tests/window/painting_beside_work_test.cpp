#include "tests/support/sheet_curves.h"
#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QSemaphore>
#include <QThreadPool>

#include <random>

namespace kriva {
namespace {

/// Knots anywhere in a square: so many crossings that working them out takes seconds.
Document randomSpline(int knots) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0, 100);
    SplineCurve curve;
    for (int i = 0; i < knots; ++i)
        curve.knots.push_back({{anywhere(random), anywhere(random)}, {}, {}, {}});
    Document document;
    document.active = test::kSpline;
    document.sheets[test::kSpline].curves = test::curves({curve});
    return document;
}

/// Every thread of the window's pool has something to do that does not end before this is over.
class BusyWorkers {
  public:
    explicit BusyWorkers(QThreadPool& pool)
        : pool_(pool) {
        for (int i = 0; i < pool.maxThreadCount(); ++i)
            pool.start([this] { mayEnd_.acquire(); });
    }
    ~BusyWorkers() {
        mayEnd_.release(pool_.maxThreadCount());
        pool_.waitForDone();
    }
    BusyWorkers(const BusyWorkers&) = delete;
    BusyWorkers& operator=(const BusyWorkers&) = delete;

  private:
    QThreadPool& pool_;
    QSemaphore mayEnd_;
};

class PaintingBesideWorkTest : public testing::Test {
  protected:
    /// What a person sees of the canvas after a change, as often as it is painted.
    void paint() {
        QApplication::processEvents();
        EXPECT_FALSE(tab.canvas().grab().isNull());
    }

    test::TestWindow shell;
    ui::SheetTab& tab = shell.shown(test::kSpline);
};

// None of these would come back if painting waited for what is worked out.

TEST_F(PaintingBesideWorkTest, firstPaintAndDragsWaitForNoWork) {
    const BusyWorkers busy(shell.window.workers());
    shell.window.session().show(randomSpline(2'000));
    paint();
    QWidget* canvas = tab.canvas().viewport();
    const QPoint start = test::pixelOf(tab, 1'000);
    QTest::mousePress(canvas, Qt::LeftButton, {}, start);
    for (int frame = 1; frame <= 50; ++frame) {
        QTest::mouseMove(canvas, start + QPoint(frame, frame));
        paint();
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, start + QPoint(50, 50));
    EXPECT_EQ(shell.steps(test::kSpline), 1);
}

TEST_F(PaintingBesideWorkTest, nothingIsWorkedOutOnTheThreadsThatPaintingWaitsFor) {
    shell.window.session().show(randomSpline(2'000));
    QApplication::processEvents();
    EXPECT_GT(shell.window.workers().activeThreadCount(), 0);
    EXPECT_EQ(QThreadPool::globalInstance()->activeThreadCount(), 0);
    paint();
}

} // namespace
} // namespace kriva
