#include "app/end_signals.h"

#include <QSocketNotifier>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <unistd.h>

namespace kriva {
namespace {

constexpr std::array kEnds = {SIGTERM, SIGINT, SIGHUP};

/// When whoever is told has not ended the program by then, it ends all the same: a little less than two seconds.
constexpr itimerspec kLast = {{}, {1, 900'000'000}};
constexpr int kTooLate = 1;

// A handler has nothing else to reach anything by.
std::atomic<int> wakeUp = -1;
std::atomic<timer_t> lastMoment = nullptr;

// Both call only what is safe in a handler: write, timer_settime, _exit.
void handleEnd(int /*signal*/) {
    const int before = errno;
    ::timer_settime(lastMoment, 0, &kLast, nullptr);
    const char byte = 0;
    [[maybe_unused]] const ssize_t count = ::write(wakeUp, &byte, 1);
    errno = before;
}
void handleLastMoment(int /*signal*/) {
    ::_exit(kTooLate);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction before = {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return;
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

} // namespace

EndSignals::EndSignals(QObject* parent)
    : QObject(parent) {
    std::array<int, 2> ends = {-1, -1};
    timer_t timer = nullptr;
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0 || ::timer_create(CLOCK_MONOTONIC, nullptr, &timer) != 0)
        return; // without them, signals end the program as they always did
    wakeUp = ends[1];
    lastMoment = timer;
    auto* notifier = new QSocketNotifier(ends[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this, notifier] {
        notifier->setEnabled(false); // once is enough
        Q_EMIT received();
    });
    handle(SIGALRM, handleLastMoment); // the timer's
    for (const int signal : kEnds)
        handle(signal, handleEnd);
}

EndSignals::~EndSignals() {
    for (const int signal : kEnds)
        handle(signal, SIG_DFL);
}

} // namespace kriva
