#include "tests/support/contrast.h"
#include "ui/base/look/desktop_scheme.h"
#include "ui/base/look/theme.h"
#include "ui/base/look/theme_style.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QProcess>
#include <QSignalSpy>
#include <QtTest/QTest>
#include <QWidget>

namespace kriva::ui {

using namespace Qt::StringLiterals;
using test::contrast;

namespace {

TEST(Palettes, everyTextIsReadableOnItsGround) {
    using Role = QPalette::ColorRole;
    const std::array<std::pair<Role, Role>, 11> pairs = {{{Role::WindowText, Role::Window},
                                                          {Role::Text, Role::Base},
                                                          {Role::Text, Role::AlternateBase},
                                                          {Role::ButtonText, Role::Button},
                                                          {Role::ButtonText, Role::Window},
                                                          {Role::HighlightedText, Role::Highlight},
                                                          {Role::ToolTipText, Role::ToolTipBase},
                                                          {Role::Link, Role::Base},
                                                          {Role::Link, Role::Window},
                                                          {Role::LinkVisited, Role::Base},
                                                          {Role::LinkVisited, Role::Window}}};
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
        for (const auto& [text, ground] : pairs)
            EXPECT_GE(contrast(palette.color(text), palette.color(ground)), 4.5) << text << " on " << ground;
    }
}

TEST(Palettes, disabledTextIsPalerAndStillThere) {
    using Role = QPalette::ColorRole;
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
        for (const auto& [text, ground] : {std::pair(Role::WindowText, Role::Window), std::pair(Role::Text, Role::Base),
                                           std::pair(Role::ButtonText, Role::Button)}) {
            const double pale = contrast(palette.color(QPalette::Disabled, text), palette.color(ground));
            EXPECT_GE(pale, 2.5);
            EXPECT_LT(pale, contrast(palette.color(text), palette.color(ground)) / 2);
        }
    }
}

/// A bus of its own with a settings portal on it that can be told what to say.
class PortalTest : public ::testing::Test {
  protected:
    class Portal : public QDBusVirtualObject {
      public:
        explicit Portal(uint initialScheme)
            : scheme(initialScheme) {}
        QString introspect(const QString&) const override { return {}; }
        bool handleMessage(const QDBusMessage& message, const QDBusConnection& connection) override {
            const bool isAsked =
                message.interface() == u"org.freedesktop.portal.Settings"_s && message.member() == u"Read"_s &&
                message.arguments() == QVariantList{u"org.freedesktop.appearance"_s, u"color-scheme"_s};
            if (!isAsked)
                return false;
            const QDBusVariant wrapped(QVariant::fromValue(QDBusVariant(scheme)));
            return connection.send(message.createReply(QVariant::fromValue(wrapped)));
        }
        uint scheme;
    };

    PortalTest() {
        daemon.start(u"dbus-daemon"_s, {u"--session"_s, u"--nofork"_s, u"--print-address"_s});
        EXPECT_TRUE(daemon.waitForReadyRead());
        const QString address = QString::fromLatin1(daemon.readLine().trimmed());
        ours = std::make_unique<QDBusConnection>(QDBusConnection::connectToBus(address, u"ours"_s));
        theirs = std::make_unique<QDBusConnection>(QDBusConnection::connectToBus(address, u"theirs"_s));
        EXPECT_TRUE(ours->isConnected() && theirs->isConnected());
    }
    ~PortalTest() override {
        QDBusConnection::disconnectFromBus(u"ours"_s);
        QDBusConnection::disconnectFromBus(u"theirs"_s);
        daemon.terminate();
        daemon.waitForFinished();
    }

    void open(Portal& portal) const {
        EXPECT_TRUE(theirs->registerVirtualObject(u"/org/freedesktop/portal/desktop"_s, &portal));
        EXPECT_TRUE(theirs->registerService(u"org.freedesktop.portal.Desktop"_s));
    }
    void say(const QString& space, const QString& key, uint scheme) const {
        QDBusMessage signal = QDBusMessage::createSignal(u"/org/freedesktop/portal/desktop"_s,
                                                         u"org.freedesktop.portal.Settings"_s, u"SettingChanged"_s);
        signal << space << key << QVariant::fromValue(QDBusVariant(scheme));
        EXPECT_TRUE(theirs->send(signal));
    }

    QProcess daemon;
    std::unique_ptr<QDBusConnection> ours;
    std::unique_ptr<QDBusConnection> theirs;
};

TEST_F(PortalTest, theAnswerOfThePortalComesLater) {
    Portal portal(1);
    open(portal);
    const DesktopScheme desktop(*ours);
    EXPECT_EQ(desktop.scheme(), Scheme::Unknown);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Dark; }));
}

TEST_F(PortalTest, aChangeOfTheDesktopIsFollowed) {
    Portal portal(2);
    open(portal);
    const DesktopScheme desktop(*ours);
    QSignalSpy changed(&desktop, &DesktopScheme::changed);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Light; }));
    say(u"org.freedesktop.appearance"_s, u"accent-color"_s, 1);
    say(u"org.gnome.desktop"_s, u"color-scheme"_s, 1);
    say(u"org.freedesktop.appearance"_s, u"color-scheme"_s, 0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Unknown; }));
    say(u"org.freedesktop.appearance"_s, u"color-scheme"_s, 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Dark; }));
    EXPECT_EQ(changed.size(), 3);
}

TEST_F(PortalTest, withoutAPortalTheSchemeStaysUnknown) {
    const DesktopScheme desktop(*ours);
    // An answer of the bus itself comes after the one about the missing portal.
    ours->call(
        QDBusMessage::createMethodCall(u"org.freedesktop.DBus"_s, u"/"_s, u"org.freedesktop.DBus"_s, u"GetId"_s));
    QCoreApplication::processEvents();
    EXPECT_EQ(desktop.scheme(), Scheme::Unknown);
    say(u"org.freedesktop.appearance"_s, u"color-scheme"_s, 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Dark; }));
}

class ThemeTest : public PortalTest {
  protected:
    ThemeTest() { QApplication::setPalette(lightPalette()); }
    ~ThemeTest() override { QApplication::setPalette(lightPalette()); }
};

TEST_F(ThemeTest, theChosenThemeReachesEveryWidget) {
    const DesktopScheme desktop(*ours);
    ThemeSwitch themes(ThemeChoice::Light, desktop);
    QSignalSpy changed(&themes, &ThemeSwitch::changed);
    const QWidget widget;
    EXPECT_EQ(widget.palette().color(QPalette::Window), lightPalette().color(QPalette::Window));
    themes.setTheme(ThemeChoice::Dark);
    QCoreApplication::processEvents();
    EXPECT_EQ(widget.palette().color(QPalette::Window), darkPalette().color(QPalette::Window));
    EXPECT_NE(qobject_cast<ThemeStyle*>(QApplication::style()), nullptr);
    themes.setTheme(ThemeChoice::Dark);
    EXPECT_EQ(changed.size(), 1);
}

TEST_F(ThemeTest, theSystemsThemeFollowsTheDesktop) {
    Portal portal(1);
    open(portal);
    const DesktopScheme desktop(*ours);
    ThemeSwitch themes(ThemeChoice::System, desktop);
    EXPECT_FALSE(themes.isDark()) << "until the answer comes, the system's palette decides";
    EXPECT_TRUE(QTest::qWaitFor([&] { return themes.isDark(); }));
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), darkPalette().color(QPalette::Window));
    themes.setTheme(ThemeChoice::Light);
    EXPECT_FALSE(themes.isDark());
    say(u"org.freedesktop.appearance"_s, u"color-scheme"_s, 2);
    EXPECT_TRUE(QTest::qWaitFor([&] { return desktop.scheme() == Scheme::Light; }));
    themes.setTheme(ThemeChoice::System);
    EXPECT_FALSE(themes.isDark());
}

TEST_F(ThemeTest, aDarkSystemPaletteDecidesWhereTheDesktopIsSilent) {
    QApplication::setPalette(darkPalette());
    const DesktopScheme desktop(*ours);
    const ThemeSwitch themes(ThemeChoice::System, desktop);
    EXPECT_TRUE(themes.isDark());
}

} // namespace
} // namespace kriva::ui
