#pragma once

#include <array>
#include <csignal>

namespace kriva::app {

/// While it lives, Ctrl+C and the other signals that ask a process to end (SIGINT, SIGTERM, SIGHUP) end it at once, as
/// they would without it, so that a shell sees by what; but not in the middle of writing a file, and not before the
/// line of progress is taken back. What is ignored (by nohup) stays so.
class Interrupts {
  public:
    Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;
    ~Interrupts();

  private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, kSignals.size()> before_{};
};

/// While it lives, the process does not end by these signals: those that came end it afterwards. So no file is left
/// that lies beside the one to write, or that is written in part.
class Uninterrupted {
  public:
    Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;
    ~Uninterrupted();
};

} // namespace kriva::app
