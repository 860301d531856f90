#pragma once

#include <QFile>
#include <QTemporaryDir>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace kriva::test {

/// A FIFO that nothing may open. Whoever reads a text with html() in it as HTML opens it, and would wait for a writer
/// for ever: a thread of the trap notices that, gives the reader an end of file, and keeps in mind what happened.
class PictureTrap {
  public:
    PictureTrap() {
        if (!folder_.isValid() || mkfifo(path_.constData(), 0600) != 0)
            std::abort();
        watcher_ = std::thread([this] { watch(); });
    }
    PictureTrap(const PictureTrap&) = delete;
    PictureTrap& operator=(const PictureTrap&) = delete;
    PictureTrap(PictureTrap&&) = delete;
    PictureTrap& operator=(PictureTrap&&) = delete;
    ~PictureTrap() {
        isOver_ = true;
        watcher_.join();
    }

    [[nodiscard]] QString html() const { return QStringLiteral("<img src=\"%1\">").arg(QFile::decodeName(path_)); }
    /// The same as a cell of a table and in XML, where no quote may stand.
    [[nodiscard]] QString htmlWithoutQuotes() const {
        return QStringLiteral("<img src=%1>").arg(QFile::decodeName(path_));
    }
    /// The same as the name of a file, where no slash may stand.
    [[nodiscard]] QString htmlWithoutSlashes() const {
        return htmlWithoutQuotes().replace(u'/', QLatin1String("&#47;"));
    }
    /// Whether the FIFO has been opened since it was made.
    [[nodiscard]] bool wasOpened() const { return wasOpened_ || hasReader(); }

  private:
    /// Opening a FIFO for writing fails with ENXIO as long as nobody reads it.
    [[nodiscard]] bool hasReader() const {
        const int end = ::open(path_.constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (end < 0)
            return errno != ENXIO;
        ::close(end);
        return true;
    }
    void watch() {
        while (!isOver_) {
            if (hasReader())
                wasOpened_ = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    QTemporaryDir folder_;
    QByteArray path_ = QFile::encodeName(folder_.filePath(QStringLiteral("trap")));
    std::atomic<bool> isOver_ = false;
    std::atomic<bool> wasOpened_ = false;
    std::thread watcher_;
};

} // namespace kriva::test
