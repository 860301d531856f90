#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QProcess>

// What is on the clipboard as another program gets it: over the X server.
namespace kriva::ui {
namespace {

/// What a program is given that asks for this type.
QByteArray pastedElsewhere(const char* type) {
    QProcess program;
    program.start(QStringLiteral("xclip"), {QStringLiteral("-selection"), QStringLiteral("clipboard"),
                                            QStringLiteral("-o"), QStringLiteral("-t"), QString::fromLatin1(type)});
    // This one answers it, so that it must not wait for it.
    EXPECT_TRUE(QTest::qWaitFor([&] { return program.state() == QProcess::NotRunning; }, 10'000));
    return program.readAllStandardOutput();
}

TEST(ClipboardOfTheDesktop, deliversACopiedFigureInAllThreeFormats) {
    test::TestWindow shell;
    shell.shown(test::kElevation);
    shell.window.findChild<QAction*>(QStringLiteral("copyFigure"))->trigger();
    const QByteArray types = pastedElsewhere("TARGETS");
    for (const char* type : {"image/svg+xml", "application/pdf", "image/png"})
        EXPECT_TRUE(types.split('\n').contains(type)) << types.toStdString();
    const QByteArray svg = pastedElsewhere("image/svg+xml");
    EXPECT_TRUE(svg.contains("<svg xmlns=\"http://www.w3.org/2000/svg\"")) << svg.left(200).toStdString();
    EXPECT_TRUE(svg.trimmed().endsWith("</svg>"));
    EXPECT_TRUE(svg.contains("id=\"curve-0\""));
    const QByteArray pdf = pastedElsewhere("application/pdf");
    EXPECT_TRUE(pdf.startsWith("%PDF-"));
    EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
    const QImage picture = QImage::fromData(pastedElsewhere("image/png"), "PNG");
    EXPECT_GT(picture.width(), 1000);
}

} // namespace
} // namespace kriva::ui
