#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QTimer>

#include <optional>

namespace kriva::ui {

/// How a file is, seen from the document that it was read into or written from.
enum class FileState {
    Same,
    Changed, ///< another program wrote something else into it
    Gone     ///< deleted, moved, or not to be read any more
};

/// Watches a document's file. What counts is what is in it: a file that is merely touched, or replaced by the same, is
/// the same.
class FileWatch : public QObject {
    Q_OBJECT
  public:
    explicit FileWatch(QObject* parent = nullptr);

    /// What was read from the file, or written to it, just now has this contentHash(). An empty path: nothing to watch.
    void watch(const QString& path, const QByteArray& hash);
    /// It was longer ago: what the file holds now is told in a moment, where it differs.
    void lookSoon();
    /// How it is right now, whatever was told.
    [[nodiscard]] FileState look() const;
    /// The same, but a file that nobody wrote since it was last looked at is not read again.
    [[nodiscard]] FileState lookIfWritten() const { return stamp_ == stampNow() ? state() : look(); }
    /// How it was when it was last told.
    [[nodiscard]] FileState state() const { return stateOf(toldHash_); }
    /// How long the file must be quiet until it is looked at: who writes it does so in several steps.
    void setPause(std::chrono::milliseconds pause) { pause_.setInterval(pause); }

  Q_SIGNALS:
    /// The file has other content than that which was told, or is gone, or is as it was.
    void changed(kriva::ui::FileState state);

  private:
    /// What differs where a file was written or replaced.
    struct Stamp {
        quint64 device = 0;
        quint64 number = 0;
        qint64 size = -1;
        qint64 written = 0; ///< ns
        qint64 altered = 0; ///< ns
        bool operator==(const Stamp&) const = default;
    };
    void follow();
    void tell();
    /// Of what is in the file; nothing where it cannot be read.
    [[nodiscard]] std::optional<QByteArray> hashNow() const;
    [[nodiscard]] FileState stateOf(const std::optional<QByteArray>& hash) const;
    [[nodiscard]] Stamp stampNow() const;

    QFileSystemWatcher watcher_;
    QTimer pause_;
    QString path_;
    QByteArray hash_;
    std::optional<QByteArray> toldHash_ = QByteArray(); ///< nothing where it was gone
    std::optional<Stamp> stamp_;                        ///< of what was looked at last
};

} // namespace kriva::ui
