#pragma once

#include <QObject>

class QDBusConnection;
class QDBusPendingCallWatcher;
class QDBusVariant;

namespace kriva::ui {

enum class Scheme { Unknown, Light, Dark };

/// Whether the desktop wants light or dark windows, asked of its settings portal over D-Bus. The answer comes later, if
/// at all: nothing waits for it, and without a bus or a portal it stays unknown.
class DesktopScheme : public QObject {
    Q_OBJECT

  public:
    /// Asks on the session's bus, if the session has one.
    explicit DesktopScheme(QObject* parent = nullptr);
    explicit DesktopScheme(const QDBusConnection& bus, QObject* parent = nullptr);

    [[nodiscard]] Scheme scheme() const { return scheme_; }

  Q_SIGNALS:
    void changed();

  private Q_SLOTS:
    void followSetting(const QString& space, const QString& key, const QDBusVariant& value);

  private:
    void ask(const QDBusConnection& bus);
    void readAnswer(QDBusPendingCallWatcher* call);
    void setScheme(const QVariant& value);

    Scheme scheme_ = Scheme::Unknown;
};

} // namespace kriva::ui
