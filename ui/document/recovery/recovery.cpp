#include "ui/document/recovery/recovery.h"

#include <QLockFile>
#include <QUuid>

#include <utility>

namespace kriva::ui {
namespace {

/// A quarter of a frame: the rest is for drawing.
constexpr std::chrono::milliseconds kSlice{4};

[[nodiscard]] QString newId() {
    return QUuid::createUuid().toString(QUuid::WithoutBraces);
}

} // namespace

Recovery::Recovery(const OpenDocument& document, RecoveryWriter& writer, QObject* parent)
    : QObject(parent)
    , document_(document)
    , writer_(writer)
    , shadow_(document)
    , id_(newId())
    , isModified_(document.isModified()) {
    quiet_.setInterval(writer.timing().quiet);
    longest_.setInterval(writer.timing().longest);
    copying_.setInterval(0);
    for (QTimer* timer : {&quiet_, &longest_, &copying_})
        timer->setSingleShot(true);
    connect(&quiet_, &QTimer::timeout, this, &Recovery::record);
    connect(&longest_, &QTimer::timeout, this, &Recovery::record);
    connect(&copying_, &QTimer::timeout, this, &Recovery::copyMore);
    connect(&shadow_, &DocumentShadow::documentChanged, this, &Recovery::noteChange);
    connect(&document, &OpenDocument::replaced, this, &Recovery::forget);
    connect(&document, &OpenDocument::modifiedChanged, this, &Recovery::follow);
    connect(&writer, &RecoveryWriter::failed, this, [this](const QString& id, const WriteError& error) {
        if (id == id_)
            Q_EMIT failed(error);
    });
}

Recovery::~Recovery() {
    if (!isKept_)
        forget();
}

void Recovery::setFile(const QString& path, const QByteArray& hash) {
    about_.path = path;
    about_.fileHash = hash;
    isFileOther_ = false;
}

void Recovery::setFileDiffers(bool differs) {
    if (std::exchange(isFileOther_, differs) != differs)
        follow(isModified_);
}

void Recovery::adopt(FoundRecovery found) {
    forget();
    id_ = found.files.id;
    about_.time = found.time;
    isRecorded_ = true;
    writer_.adopt(std::move(found));
}

void Recovery::noteChange() {
    isKept_ = false;
    hasNews_ = true;
    about_.time = QDateTime::currentDateTime();
    quiet_.start();
    if (!longest_.isActive())
        longest_.start();
}

void Recovery::follow(bool isModified) {
    isModified_ = isModified;
    if (!isUnsaved())
        return forget();
    hasNews_ = true;
    if (!about_.time.isValid())
        about_.time = QDateTime::currentDateTime();
    quiet_.start();
}

void Recovery::record() {
    quiet_.stop();
    longest_.stop();
    if (!isUnsaved())
        return forget();
    if (hasNews_)
        copyMore();
    else if (!differsFromFile())
        quiet_.start(); // a gesture that ends where it began tells nobody
}

void Recovery::copyMore() {
    if (shadow_.catchUp(kSlice))
        handOver();
    else
        copying_.start();
}

void Recovery::handOver() {
    copying_.stop();
    hasNews_ = false;
    isRecorded_ = true;
    writer_.write(id_, shadow_.snapshot(), about_);
    if (!differsFromFile())
        quiet_.start();
}

void Recovery::keep() {
    if (isUnsaved() && (hasNews_ || !isRecorded_)) {
        shadow_.catchUp(std::chrono::nanoseconds::max());
        handOver();
    }
    isKept_ = true;
}

void Recovery::forget() {
    for (QTimer* timer : {&quiet_, &longest_, &copying_})
        timer->stop();
    hasNews_ = false;
    shadow_.drop();
    if (std::exchange(isRecorded_, false))
        writer_.remove(id_);
}

} // namespace kriva::ui
