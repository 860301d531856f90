#include "ui/document/recovery/recovery_writer.h"

#include "core/io/json/document_json.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/document/state_folder.h"

#include <QLockFile>

#include <cerrno>
#include <csignal>
#include <utility>

namespace kriva::ui {

RecoveryWriter::RecoveryWriter(RecoveryTiming timing, QObject* parent)
    : QObject(parent)
    , timing_(timing) {
    // Signals are for the thread of the window: a thread takes over what is blocked where it is started.
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this] { work(); });
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

RecoveryWriter::~RecoveryWriter() {
    {
        const std::lock_guard guard(mutex_);
        isEnding_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void RecoveryWriter::write(const QString& id, DocumentSnapshot snapshot, RecoveryNote about) {
    enqueue({id, true,
             [this, id, snapshot = std::move(snapshot), about = std::move(about)] { doWrite(id, snapshot, about); }});
}

void RecoveryWriter::remove(const QString& id) {
    enqueue({id, false, [this, id] { doRemove(id); }});
}

void RecoveryWriter::adopt(FoundRecovery found) {
    const QByteArray hash = found.hash;
    const QString id = found.files.id;
    // What is called may be copied, a lock may not.
    const auto lock = std::make_shared<std::unique_ptr<QLockFile>>(std::move(found.lock));
    enqueue({id, false, [this, id, hash, lock] { kept_[id] = {std::move(*lock), hash}; }});
}

void RecoveryWriter::enqueue(Job job) {
    {
        const std::lock_guard guard(mutex_);
        std::erase_if(jobs_, [&](const Job& waiting) { return waiting.isWrite && waiting.id == job.id; });
        jobs_.push_back(std::move(job));
    }
    changed_.notify_all();
}

bool RecoveryWriter::finishWithin(std::chrono::milliseconds most) {
    std::unique_lock guard(mutex_);
    return changed_.wait_for(guard, most, [this] { return jobs_.empty() && !isBusy_; });
}

bool RecoveryWriter::isAllWritten() const {
    const std::lock_guard guard(mutex_);
    return failed_.empty();
}

void RecoveryWriter::work() {
    std::unique_lock guard(mutex_);
    for (;;) {
        changed_.wait(guard, [this] { return isEnding_ || !jobs_.empty(); });
        if (jobs_.empty())
            return;
        const Job job = std::move(jobs_.front());
        jobs_.pop_front();
        isBusy_ = true;
        guard.unlock();
        job.doIt();
        guard.lock();
        isBusy_ = false;
        changed_.notify_all();
    }
}

void RecoveryWriter::doWrite(const QString& id, const DocumentSnapshot& snapshot, RecoveryNote note) {
    const std::string text = writeDocument(documentOf(snapshot), 0);
    const QByteArrayView bytes(text.data(), static_cast<qsizetype>(text.size()));
    const auto error = tryWrite(id, bytes, std::move(note));
    bool isNews = false;
    {
        const std::lock_guard guard(mutex_);
        isNews = error ? failed_.insert(id).second : failed_.erase(id) > 0;
    }
    if (!error)
        Q_EMIT written(id);
    else if (isNews)
        Q_EMIT failed(id, *error);
}

std::optional<WriteError> RecoveryWriter::tryWrite(const QString& id, QByteArrayView bytes, RecoveryNote note) {
    const auto folder = privateFolder(QStringLiteral("recovery"));
    if (const WriteError* error = std::get_if<WriteError>(&folder))
        return *error;
    const RecoveryFiles files{std::get<QString>(folder), id};
    Kept& kept = kept_[id];
    if (!kept.lock) {
        auto lock = std::make_unique<QLockFile>(files.lock());
        errno = 0;
        if (!lockNow(*lock))
            return WriteError{lock->error() == QLockFile::PermissionError ? WriteFault::Denied : WriteFault::Failed,
                              errno};
        kept.lock = std::move(lock);
    }
    note.hash = contentHash(bytes);
    note.previousHash = kept.hash;
    const auto error = writeRecovery(files, note, bytes);
    if (!error)
        kept.hash = note.hash;
    return error;
}

void RecoveryWriter::doRemove(const QString& id) {
    const auto folder = privateFolder(QStringLiteral("recovery"));
    if (const QString* path = std::get_if<QString>(&folder))
        removeRecovery({*path, id});
    kept_.erase(id); // and gives up the lock
    const std::lock_guard guard(mutex_);
    failed_.erase(id);
}

} // namespace kriva::ui
