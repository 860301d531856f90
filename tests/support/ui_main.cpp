#include <gtest/gtest.h>
#include <QApplication>
#include <QFont>
#include <QLocale>
#include <QTemporaryDir>

namespace {

/// No test reads or leaves anything in the home of the person who runs it.
void moveHomeTo(const QByteArray& folder) {
    for (const char* name :
         {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"}) {
        qputenv(name, folder);
    }
}

} // namespace

// Widgets look the same on every machine: one style, one font, one scale; no display but for tests of the display.
int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const QTemporaryDir home;
    moveHomeTo(home.path().toUtf8());
    qputenv("QT_QPA_PLATFORM", qEnvironmentVariable("KRIVA_TEST_PLATFORM", QStringLiteral("offscreen")).toLatin1());
    qputenv("QT_SCALE_FACTOR", "1");
    QLocale::setDefault(QLocale(QLocale::English)); // whatever the locale of the process: what is read back is fixed
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication::setFont(QFont(QStringLiteral("DejaVu Sans"), 10));
    return RUN_ALL_TESTS();
}
