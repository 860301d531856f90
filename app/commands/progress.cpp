#include "app/commands/progress.h"

#include "ui/base/language/plain_text.h"

#include <QCoreApplication>

#include <atomic>
#include <csignal>
#include <unistd.h>

namespace kriva::app {

using namespace std::chrono_literals;

namespace {

constexpr auto kPatience = 2s;
constexpr auto kStep = 1s; // the line counts seconds
constexpr char kErase[] = "\r\x1b[K";

class ProgressText {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
  public:
    static QString atWork(const QString& work, qint64 seconds) {
        return tr("%1: at work for %2 s; Ctrl+C ends it").arg(work, QString::number(seconds));
    }
};

// There is one stderr, and a signal's handler is given nothing.
std::mutex lineMutex;
std::atomic<bool> isLineShown = false;
bool isLineOver = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler reads it");

void writeLine(const char* bytes, std::size_t size) {
    // In one piece, so that nothing else gets in between. A terminal that is gone needs no line.
    (void)!::write(STDERR_FILENO, bytes, size);
}

void showLine(const QByteArray& line) {
    const std::scoped_lock lock(lineMutex);
    if (isLineOver)
        return;
    isLineShown = true;
    writeLine(line.constData(), static_cast<std::size_t>(line.size()));
}

bool canTakeLinesBack() {
    const QByteArray terminal = qgetenv("TERM");
    return ::isatty(STDERR_FILENO) == 1 && !terminal.isEmpty() && terminal != "dumb";
}

/// The signals that end a process are for the thread that works: a handler there ends it just as well.
void blockSignals() {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

} // namespace

QByteArray progressLine(const QString& work, std::chrono::milliseconds passed) {
    if (passed < kPatience)
        return {};
    const qint64 seconds = std::chrono::duration_cast<std::chrono::seconds>(passed).count();
    const QString line = QStringLiteral("kriva: ") + ui::printable(ProgressText::atWork(work, seconds));
    // Longer than the terminal is wide, it is cut and not broken: only one line can be taken back.
    return "\r\x1b[?7l" + line.toUtf8() + "\x1b[K\x1b[?7h";
}

QString fileOf(const QStringList& files, qsizetype index) {
    if (files.size() == 1)
        return files.front();
    return QStringLiteral("%1 (%2/%3)").arg(files[index], QString::number(index + 1), QString::number(files.size()));
}

Progress::Progress() {
    if (canTakeLinesBack())
        thread_ = std::jthread([this](const std::stop_token& end) { tellUntil(end); });
}

Progress::~Progress() {
    if (thread_.joinable()) {
        thread_.request_stop();
        thread_.join();
    }
    eraseProgress();
}

void Progress::goOnWith(const QString& work) {
    const std::scoped_lock lock(mutex_);
    work_ = work;
}

void Progress::tellUntil(const std::stop_token& end) {
    blockSignals();
    const auto start = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    for (auto next = start + kPatience; !end.stop_requested(); next += kStep) {
        wakes_.wait_until(lock, end, next, [] { return false; });
        if (end.stop_requested())
            return;
        const auto passed = std::chrono::steady_clock::now() - start;
        showLine(progressLine(work_, std::chrono::duration_cast<std::chrono::milliseconds>(passed)));
    }
}

void eraseProgress() {
    const std::scoped_lock lock(lineMutex);
    if (isLineShown.exchange(false))
        writeLine(kErase, sizeof kErase - 1);
}

void endProgress() {
    eraseProgress();
    const std::scoped_lock lock(lineMutex);
    isLineOver = true;
}

void eraseProgressInHandler() {
    if (isLineShown)
        writeLine(kErase, sizeof kErase - 1);
}

} // namespace kriva::app
