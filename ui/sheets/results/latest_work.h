#pragma once

#include <QObject>
#include <QTimer>

#include <functional>

namespace kriva::ui {

/// Something worked out again after every change: once per turn of the event loop, and on another thread where it took
/// longer than an eighth of a frame the last time. What is out of date when it is ready is dropped.
class LatestWork : public QObject {
    Q_OBJECT
  public:
    /// Takes what was worked out, on the thread of the window.
    using Take = std::function<void()>;
    /// The work itself, on any thread: it holds copies of all that it looks at.
    using Work = std::function<Take()>;

    /// `next` gathers what is to be worked out at the moment. No take is called after the end of this object.
    explicit LatestWork(std::function<Work()> next, QObject* parent = nullptr);

    /// Something changed.
    void doSoon();
    /// Something else altogether is shown: how long it takes is not known.
    void startOver();

  private:
    void doNow();
    void doElsewhere(Work work);
    void finish(const Take& take, qint64 nanoseconds);

    std::function<Work()> next_;
    QTimer pending_;
    bool isWorking_ = false;   ///< on another thread
    bool isOutOfDate_ = false; ///< what is being worked out there
    bool isQuick_ = false;     ///< it took less than an eighth of a frame the last time
};

} // namespace kriva::ui
