#include "ui/document/sharing/file_watch.h"

#include "ui/document/bounded_read.h"
#include "ui/document/sharing/content_hash.h"

#include <QFile>
#include <QFileInfo>

#include <sys/stat.h>
#include <utility>

namespace kriva::ui {
namespace {

constexpr std::chrono::milliseconds kPause{300};

} // namespace

FileWatch::FileWatch(QObject* parent)
    : QObject(parent) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPause);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, &pause_, qOverload<>(&QTimer::start));
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, [this] {
        if (!pause_.isActive()) // in some folders there is always something going on
            pause_.start();
    });
    connect(&pause_, &QTimer::timeout, this, &FileWatch::tell);
}

void FileWatch::watch(const QString& path, const QByteArray& hash) {
    if (const QStringList watched = watcher_.files() + watcher_.directories(); !watched.isEmpty())
        watcher_.removePaths(watched);
    pause_.stop();
    const bool wasSame = state() == FileState::Same;
    path_ = path.isEmpty() ? path : QFileInfo(path).absoluteFilePath();
    hash_ = hash;
    stamp_ = stampNow();
    toldHash_ = hash;
    if (!wasSame)
        Q_EMIT changed(FileState::Same);
    follow();
}

void FileWatch::lookSoon() {
    stamp_.reset();
    pause_.start();
}

void FileWatch::follow() {
    if (path_.isEmpty())
        return;
    // Qt drops a file that is replaced, and sees one that comes back by its folder alone.
    if (!watcher_.files().contains(path_) && QFileInfo::exists(path_))
        watcher_.addPath(path_);
    const QString folder = QFileInfo(path_).absolutePath();
    if (!watcher_.directories().contains(folder) && QFileInfo::exists(folder))
        watcher_.addPath(folder);
}

std::optional<QByteArray> FileWatch::hashNow() const {
    const auto bytes = boundedRead(path_);
    const QByteArray* read = std::get_if<QByteArray>(&bytes);
    return read ? std::optional(contentHash(*read)) : std::nullopt;
}

FileState FileWatch::stateOf(const std::optional<QByteArray>& hash) const {
    if (!hash)
        return FileState::Gone;
    return *hash == hash_ ? FileState::Same : FileState::Changed;
}

FileState FileWatch::look() const {
    return path_.isEmpty() ? FileState::Same : stateOf(hashNow());
}

FileWatch::Stamp FileWatch::stampNow() const {
    struct stat status = {};
    if (::stat(QFile::encodeName(path_).constData(), &status) != 0)
        return {};
    const auto nanoseconds = [](const timespec& time) { return time.tv_sec * 1'000'000'000 + time.tv_nsec; };
    return {status.st_dev, status.st_ino, status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

void FileWatch::tell() {
    follow();
    if (path_.isEmpty())
        return;
    const Stamp stamp = stampNow();
    if (std::exchange(stamp_, stamp) == stamp)
        return; // something else in the folder
    const std::optional<QByteArray> hash = hashNow();
    if (std::exchange(toldHash_, hash) != hash)
        Q_EMIT changed(stateOf(hash));
}

} // namespace kriva::ui
