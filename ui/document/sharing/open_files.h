#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <variant>
#include <vector>

class QLockFile;

namespace kriva::ui {

/// Which files the windows of this program have open. Each is locked in the state folder as well, so that other
/// programs of ours know; nobody else is kept from anything. Who has a file open beside another program has a lock of
/// its own, which counts for those who come later as the first one does.
class OpenFiles : public QObject {
    Q_OBJECT
  public:
    /// A file that is somebody's as long as this lives. The files outlive it.
    class Claim {
      public:
        ~Claim();
        Q_DISABLE_COPY_MOVE(Claim)

        /// Whether it is one on this file, whatever the file is called.
        [[nodiscard]] bool isOn(const QString& path) const;
        /// Whether nobody who had the file before has it still: it is the first one from now on.
        [[nodiscard]] bool comesFirst() const;

      private:
        friend class OpenFiles;
        Claim(OpenFiles& files, QString key, const QObject* holder);
        OpenFiles& files_;
        QString key_;
        const QObject* holder_;
    };
    struct HeldElsewhere {};

    explicit OpenFiles(QObject* parent = nullptr);
    ~OpenFiles() override;

    /// The file is the holder's from now on, unless somebody else has it, in this program or another.
    [[nodiscard]] std::variant<std::unique_ptr<Claim>, HeldElsewhere> claim(const QString& path, const QObject* holder);
    /// The same beside whoever has it.
    [[nodiscard]] std::unique_ptr<Claim> claimBeside(const QString& path, const QObject* holder);
    /// Who has it in this program, the first of them; null where nobody does.
    [[nodiscard]] const QObject* holderOf(const QString& path) const;
    /// Asks the one who has it in this program to show it; whether there is one.
    bool bringUp(const QString& path);

  Q_SIGNALS:
    void bringUpAsked(const QObject* holder);

  private:
    /// What this program has of a file.
    struct Held {
        std::vector<const QObject*> holders; ///< in the order in which they came
        std::unique_ptr<QLockFile> first;    ///< the lock of whoever has it first, in all programs
        std::unique_ptr<QLockFile> beside;   ///< one of its own, where another program came first
    };
    [[nodiscard]] std::unique_ptr<Claim> claimed(const QString& key, Held held, const QObject* holder);
    void release(const QString& key, const QObject* holder);

    std::map<QString, Held> held_; ///< by the canonical path of the file
};

} // namespace kriva::ui
