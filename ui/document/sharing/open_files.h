#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <variant>

class QLockFile;

namespace kriva::ui {

/// Which files the windows of this program have open. Each is locked in the state folder as well, so that other
/// programs of ours know; nobody else is kept from anything.
class OpenFiles : public QObject {
    Q_OBJECT
  public:
    /// A file that is somebody's as long as this lives. The files outlive it.
    class Claim {
      public:
        ~Claim();
        Q_DISABLE_COPY_MOVE(Claim)

      private:
        friend class OpenFiles;
        Claim(OpenFiles& files, QString key, std::unique_ptr<QLockFile> lock);
        OpenFiles& files_;
        QString key_;
        std::unique_ptr<QLockFile> lock_; ///< nothing where there is no state folder
    };
    struct HeldElsewhere {};

    explicit OpenFiles(QObject* parent = nullptr);
    ~OpenFiles() override;

    /// The file is the holder's from now on, unless somebody else has it, in this program or another.
    [[nodiscard]] std::variant<std::unique_ptr<Claim>, HeldElsewhere> claim(const QString& path, const QObject* holder);
    /// Who has it in this program; null where nobody does.
    [[nodiscard]] const QObject* holderOf(const QString& path) const;
    /// Asks the one who has it in this program to show it; whether there is one.
    bool bringUp(const QString& path);

  Q_SIGNALS:
    void bringUpAsked(const QObject* holder);

  private:
    std::map<QString, const QObject*> holders_; ///< by the canonical path of the file
};

} // namespace kriva::ui
