#pragma once

#include "ui/document/recovery/document_shadow.h"
#include "ui/document/recovery/found_recoveries.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>

namespace kriva::ui {

/// How long unsaved work may be nowhere but in the window: after the last change, and after the first of many. What is
/// promised is 2 s and 10 s; making and writing the bytes of a large document takes its part of it.
struct RecoveryTiming {
    std::chrono::milliseconds quiet{1'000};
    std::chrono::milliseconds longest{5'000};
};

/// Writes and removes the unsaved work of all windows of the program, on a thread of its own: neither the window nor
/// what is worked out elsewhere waits for a disk. One file after the other, in the order asked for; of several writes
/// of one document that wait, the last one alone is done.
class RecoveryWriter : public QObject {
    Q_OBJECT
  public:
    explicit RecoveryWriter(RecoveryTiming timing = {}, QObject* parent = nullptr);
    /// Ends when all is done.
    ~RecoveryWriter() override;

    [[nodiscard]] const RecoveryTiming& timing() const { return timing_; }

    /// `about.hash` and `about.previousHash` are filled in.
    void write(const QString& id, DocumentSnapshot snapshot, RecoveryNote about);
    void remove(const QString& id);
    /// Goes on with what another program left.
    void adopt(FoundRecovery found);
    /// Whether all is done, waiting for it no longer than that.
    [[nodiscard]] bool finishWithin(std::chrono::milliseconds most);
    /// Whether the last write of each document came to the disk.
    [[nodiscard]] bool isAllWritten() const;

  Q_SIGNALS:
    void written(const QString& id);
    /// Once for each document; not again until it could be written.
    void failed(const QString& id, const kriva::ui::WriteError& error);

  private:
    struct Job {
        QString id;
        bool isWrite;
        std::function<void()> doIt;
    };
    /// What the thread has of one document.
    struct Kept {
        std::unique_ptr<QLockFile> lock;
        QByteArray hash; ///< of the work that is on the disk
    };

    void enqueue(Job job);
    void work();
    void doWrite(const QString& id, const DocumentSnapshot& snapshot, RecoveryNote note);
    void doRemove(const QString& id);
    [[nodiscard]] std::optional<WriteError> tryWrite(const QString& id, QByteArrayView bytes, RecoveryNote note);

    const RecoveryTiming timing_;
    std::map<QString, Kept> kept_; ///< of the thread alone
    mutable std::mutex mutex_;     ///< for all below
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    bool isBusy_ = false;
    bool isEnding_ = false;
    std::set<QString> failed_; ///< the documents whose last write failed
    std::thread thread_;       ///< the last member: it looks at all the others
};

} // namespace kriva::ui
