#include "ui/base/look/desktop_scheme.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QFileInfo>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

// https://flatpak.github.io/xdg-desktop-portal/docs/doc-org.freedesktop.portal.Settings.html
const auto kService = u"org.freedesktop.portal.Desktop"_s;
const auto kPath = u"/org/freedesktop/portal/desktop"_s;
const auto kInterface = u"org.freedesktop.portal.Settings"_s;
const auto kSpace = u"org.freedesktop.appearance"_s;
const auto kKey = u"color-scheme"_s;
constexpr uint kPrefersDark = 1;
constexpr uint kPrefersLight = 2;

/// Without this look, connecting would start a bus of its own and wait for it.
[[nodiscard]] bool sessionHasBus() {
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + u"/bus"_s);
}

} // namespace

DesktopScheme::DesktopScheme(QObject* parent)
    : QObject(parent) {
    if (sessionHasBus())
        ask(QDBusConnection::sessionBus());
}

DesktopScheme::DesktopScheme(const QDBusConnection& bus, QObject* parent)
    : QObject(parent) {
    ask(bus);
}

void DesktopScheme::ask(const QDBusConnection& bus) {
    if (!bus.isConnected())
        return;
    // No service is named: Qt would look up its owner and wait for the answer.
    QDBusConnection connection(bus);
    connection.connect({}, kPath, kInterface, u"SettingChanged"_s, this,
                       SLOT(followSetting(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(kService, kPath, kInterface, u"Read"_s);
    question << kSpace << kKey;
    auto* call = new QDBusPendingCallWatcher(connection.asyncCall(question), this);
    connect(call, &QDBusPendingCallWatcher::finished, this, &DesktopScheme::readAnswer);
}

void DesktopScheme::readAnswer(QDBusPendingCallWatcher* call) {
    const QDBusPendingReply<QDBusVariant> reply = *call;
    if (reply.isValid())
        setScheme(reply.value().variant());
    call->deleteLater();
}

void DesktopScheme::followSetting(const QString& space, const QString& key, const QDBusVariant& value) {
    if (space == kSpace && key == kKey)
        setScheme(value.variant());
}

void DesktopScheme::setScheme(const QVariant& value) {
    // Read wraps the value in a second variant, the signal does not.
    const bool isWrapped = value.metaType() == QMetaType::fromType<QDBusVariant>();
    const uint number = (isWrapped ? value.value<QDBusVariant>().variant() : value).toUInt();
    const Scheme scheme = number == kPrefersDark    ? Scheme::Dark
                          : number == kPrefersLight ? Scheme::Light
                                                    : Scheme::Unknown;
    if (scheme == scheme_)
        return;
    scheme_ = scheme;
    Q_EMIT changed();
}

} // namespace kriva::ui
