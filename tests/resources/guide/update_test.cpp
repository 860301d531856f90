#include "core/io/svg/svg_writer.h"
#include "tests/support/sheet_svg.h"
#include "ui/base/examples.h"
#include "ui/base/language/language.h"
#include "ui/figures/caption_text.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace kriva::ui {
namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

TEST(GuidePictures, areWrittenByOneCommandAndAlwaysTheSame) {
    const QTemporaryDir into;
    const QString folder = QStringLiteral(KRIVA_SOURCE_DIR) + QStringLiteral("/resources/guide");
    QProcess update;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("KRIVA"), QStringLiteral(KRIVA_PROGRAM));
    update.setProcessEnvironment(environment);
    update.start(folder + QStringLiteral("/update"), {into.path()});
    ASSERT_TRUE(update.waitForFinished(240'000));
    ASSERT_EQ(update.exitCode(), 0) << update.readAllStandardError().constData();

    const QStringList figures = QDir(folder + QStringLiteral("/figures")).entryList({QStringLiteral("*.kriva")});
    ASSERT_GT(figures.size(), 10);
    for (const Language language : kLanguages) {
        const LanguageSwitch spoken(language);
        const QDir written(into.filePath(languageCode(language)));
        EXPECT_EQ(written.entryList({QStringLiteral("*.svg")}).size(), figures.size());
        for (const QString& figure : figures) {
            const Document document = exampleDocument(QStringLiteral(":/guide/figures/") + figure);
            const std::string drawn = test::sheetSvg(document, document.active, textSource());
            EXPECT_EQ(contentOf(written.filePath(figure.chopped(6) + QStringLiteral(".svg"))).toStdString(), drawn);
        }
    }
}

} // namespace
} // namespace kriva::ui
