#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace kriva {
namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(GuidePictures, areWrittenByOneCommandEveryTimeTheSame) {
    const QTemporaryDir one, two;
    const QString folder = QStringLiteral(KRIVA_SOURCE_DIR) + QStringLiteral("/resources/guide");
    for (const QTemporaryDir* into : {&one, &two}) {
        QProcess update;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("KRIVA"), QStringLiteral(KRIVA_PROGRAM));
        update.setProcessEnvironment(environment);
        update.start(folder + QStringLiteral("/update"), {into->path()});
        ASSERT_TRUE(update.waitForFinished(120'000));
        EXPECT_EQ(update.exitCode(), 0) << update.readAllStandardError().constData();
    }
    const QStringList figures = QDir(folder + QStringLiteral("/figures")).entryList({QStringLiteral("*.kriva")});
    ASSERT_GT(figures.size(), 10);
    for (const char* language : {"en", "bg", "sl", "uk"}) {
        for (const QString& figure : figures) {
            const QString name = QStringLiteral("/%1/%2.svg").arg(QLatin1String(language), figure.chopped(6));
            const QByteArray svg = contentOf(one.path() + name);
            EXPECT_TRUE(svg.contains("<svg")) << name.toStdString();
            EXPECT_EQ(svg, contentOf(two.path() + name)) << name.toStdString();
        }
    }
}

} // namespace
} // namespace kriva
