#pragma once

#include <QByteArray>
#include <QStringList>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace kriva::app {

/// What a terminal is to show of work that has taken so long, over the line that it showed before; empty for the first
/// two seconds. What is worked on may come from outside.
[[nodiscard]] QByteArray progressLine(const QString& work, std::chrono::milliseconds passed);

/// One of several files, and which of them it is: "b.svg (2/5)"; the name alone where it is the only one.
[[nodiscard]] QString fileOf(const QStringList& files, qsizetype index);

/// While it lives, a line on stderr tells from the third second on what is worked on and for how long. Nothing is told
/// where stderr is no terminal, or is one that cannot take a line back.
class Progress {
  public:
    Progress();
    explicit Progress(const QString& work)
        : Progress() {
        goOnWith(work);
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    void goOnWith(const QString& work);

  private:
    void tellUntil(const std::stop_token& end);

    std::mutex mutex_; ///< of what is worked on
    QString work_;
    std::condition_variable_any wakes_;
    std::jthread thread_;
};

/// Takes the line back, which may come again.
void eraseProgress();

/// Takes it back for good: the output that was asked for may stand on the same terminal.
void endProgress();

/// The same inside of a signal's handler, before the process ends.
void eraseProgressInHandler();

} // namespace kriva::app
