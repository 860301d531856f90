#include "app/commands/interrupts.h"

#include "app/commands/progress.h"

#include <atomic>
#include <cerrno>

namespace kriva::app {
namespace {

// A handler is given nothing but the number of its signal, and may run in any thread.
std::atomic<bool> isHeld = false;
std::atomic<int> heldSignal = 0;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

/// Calls nothing that a handler may not.
void endBySignal(int number) {
    eraseProgressInHandler();
    (void)std::signal(number, SIG_DFL);
    (void)std::raise(number); // inside a handler it comes on return
}

extern "C" void endOrHold(int number) {
    const int error = errno;
    heldSignal = number;
    if (!isHeld)
        endBySignal(number);
    errno = error;
}

} // namespace

Interrupts::Interrupts() {
    struct sigaction action = {};
    action.sa_handler = endOrHold;
    action.sa_flags = SA_RESTART; // a held signal must not make a write fail
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN)
            ::sigaction(kSignals[i], &action, nullptr);
    }
}

Interrupts::~Interrupts() {
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        ::sigaction(kSignals[i], &before_[i], nullptr);
}

Uninterrupted::Uninterrupted() {
    isHeld = true;
}

Uninterrupted::~Uninterrupted() {
    isHeld = false;
    if (const int number = heldSignal)
        endBySignal(number);
}

} // namespace kriva::app
