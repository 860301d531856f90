#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QProcess>

// What lies over what is for the window manager to say.
namespace kriva::ui {
namespace {

void movePointerTo(QPoint place) {
    QProcess::execute(QStringLiteral("xdotool"),
                      {QStringLiteral("mousemove"), QString::number(place.x()), QString::number(place.y())});
}

/// Whether the pointer in the middle of a panel is over the panel and not over what hides it.
bool isOnTop(const QDockWidget& dock) {
    movePointerTo({0, 0});
    movePointerTo(dock.geometry().center());
    return QTest::qWaitFor([&] { return dock.underMouse(); }, 5'000);
}

TEST(FloatingPanelsOfTheDesktop, lieOverAWindowThatIsOpenedWithThem) {
    const SheetIndex sheet = startDocument().active;
    const QString name = QString::fromUtf8(sheetName(sheet));
    Preferences preferences;
    const QByteArray before = preferences.panelLayout(name);
    {
        test::TestWindow first;
        auto* dock = first.shown(sheet).findChild<QDockWidget*>(QStringLiteral("properties"));
        dock->setFloating(true);
        dock->setGeometry({first.window.geometry().center() - QPoint(150, 150), QSize(300, 300)});
        ASSERT_TRUE(QTest::qWaitForWindowExposed(dock));
        preferences.setPanelLayout(name, first.window.tab(sheet).panels().layout().state());
    }
    test::TestWindow next;
    auto* dock = next.window.tab(sheet).findChild<QDockWidget*>(QStringLiteral("properties"));
    ASSERT_TRUE(dock->isFloating());
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dock));
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&next.window));
    EXPECT_TRUE(isOnTop(*dock));
    next.window.activateWindow();
    next.window.raise();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&next.window));
    EXPECT_TRUE(isOnTop(*dock)) << "it belongs to its window";
    preferences.setPanelLayout(name, before);
}

} // namespace
} // namespace kriva::ui
