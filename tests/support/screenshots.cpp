#include "tests/support/test_window.h"

#include <QCursor>

// screenshots FOLDER: the four tabs in both themes, as resources/screenshots/update wants them. The pixel ratio is that
// of QT_SCALE_FACTOR, and the name of a picture tells it: "spline-dark@2x.png".
int main(int argc, char** argv) {
    using namespace kriva;
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    if (argc != 2)
        return 2;
    const QString folder = QString::fromLocal8Bit(argv[1]);
    test::TestWindow shell;
    for (const bool isDark : {false, true}) {
        shell.theme.setTheme(isDark ? ui::ThemeChoice::Dark : ui::ThemeChoice::Light);
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
            shell.shown(sheet);
            test::settle();
            const QPixmap picture = shell.window.grab();
            const QString ratio =
                picture.devicePixelRatio() > 1 ? QStringLiteral("@%1x").arg(picture.devicePixelRatio()) : QString();
            const std::string_view name = sheetName(sheet);
            if (!picture.save(QStringLiteral("%1/%2%3%4.png")
                                  .arg(folder, QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())),
                                       isDark ? QStringLiteral("-dark") : QString(), ratio)))
                return 1;
        }
    }
    return 0;
}
