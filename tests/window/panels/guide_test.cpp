#include "tests/support/test_window.h"
#include "ui/panels/guide/guide_panel.h"

#include <gtest/gtest.h>
#include <QDockWidget>
#include <QFile>
#include <QScrollBar>
#include <QTextBlock>

namespace kriva::ui {
namespace {

using test::TestWindow;

GuidePanel& guideOf(SheetTab& tab) {
    return *tab.findChild<GuidePanel*>();
}

void pressF1(MainWindow& window) {
    window.activateWindow();
    QApplication::processEvents();
    QTest::keyClick(&window, Qt::Key_F1);
    test::settle();
}

QString titleOf(const GuidePanel& guide) {
    return guide.document()->firstBlock().text();
}

QImage pictureOf(const GuidePanel& guide, const QString& url) {
    return guide.document()->resource(QTextDocument::ImageResource, QUrl(url)).value<QImage>();
}

/// The pictures of a page that are not there.
int missingPictures(const GuidePanel& guide) {
    int missing = 0;
    for (QTextBlock block = guide.document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().isImageFormat()) {
                const QString name = part.fragment().charFormat().toImageFormat().name();
                missing += pictureOf(guide, name).isNull() ? 1 : 0;
            }
    return missing;
}

TEST(Guide, waitsBehindResults) {
    TestWindow shell;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        EXPECT_EQ(shell.shown(sheet).findChild<GuidePanel*>(), nullptr) << "it is made when it is seen";
    }
}

TEST(Guide, f1ShowsThePageOfTheShownTab) {
    TestWindow shell;
    QStringList titles;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        SheetTab& tab = shell.shown(sheet);
        pressF1(shell.window);
        GuidePanel& guide = guideOf(tab);
        EXPECT_FALSE(guide.visibleRegion().isEmpty());
        EXPECT_TRUE(guide.hasFocus()) << "so that the keyboard scrolls it";
        EXPECT_GT(guide.toPlainText().size(), 2000);
        EXPECT_EQ(missingPictures(guide), 0);
        titles.append(titleOf(guide));
    }
    EXPECT_EQ(titles, (QStringList{QStringLiteral("Elevation"), QStringLiteral("Subdivision"), QStringLiteral("Spline"),
                                   QStringLiteral("Combined")}));
}

TEST(Guide, f1BringsBackWhatWasClosedAndGivesItRoom) {
    TestWindow shell;
    SheetTab& tab = shell.shown(test::kSpline);
    auto* dock = tab.findChild<QDockWidget*>(QStringLiteral("guide"));
    dock->close();
    pressF1(shell.window);
    EXPECT_TRUE(dock->isVisible());
    EXPECT_GE(dock->height(), tab.height() / 2);
    EXPECT_GE(dock->width(), 400);
}

TEST(Guide, followsTheLanguageAtOnceAndStaysWhereItWasRead) {
    TestWindow shell;
    SheetTab& tab = shell.shown(test::kSubdivision);
    pressF1(shell.window);
    GuidePanel& guide = guideOf(tab);
    QScrollBar* bar = guide.verticalScrollBar();
    bar->setValue(bar->maximum() / 2);
    const QList<std::pair<Language, QString>> titles{{Language::Bulgarian, QStringLiteral("Подразделяне")},
                                                     {Language::Slovenian, QStringLiteral("Subdivizija")},
                                                     {Language::Ukrainian, QStringLiteral("Підрозбиття")},
                                                     {Language::English, QStringLiteral("Subdivision")}};
    for (const auto& [language, title] : titles) {
        shell.language.setLanguage(language);
        QApplication::sendPostedEvents();
        test::settle();
        EXPECT_EQ(titleOf(guide).toStdString(), title.toStdString());
        EXPECT_EQ(missingPictures(guide), 0);
        EXPECT_NEAR(static_cast<double>(bar->value()) / bar->maximum(), 0.5, 0.02);
    }
}

TEST(Guide, paintsItsPicturesAnewForAnotherThemeAndWidth) {
    TestWindow shell;
    SheetTab& tab = shell.shown(test::kElevation);
    pressF1(shell.window);
    GuidePanel& guide = guideOf(tab);
    const auto picture = [&] { return pictureOf(guide, QStringLiteral("figure:elevation-once")); };
    const QImage light = picture();
    ASSERT_FALSE(light.isNull());
    shell.theme.setTheme(ThemeChoice::Dark);
    QApplication::sendPostedEvents();
    test::settle();
    EXPECT_NE(picture(), light);
    EXPECT_EQ(picture().size(), light.size());
    tab.resizeDocks({tab.findChild<QDockWidget*>(QStringLiteral("guide"))}, {300}, Qt::Horizontal);
    test::settle();
    EXPECT_LT(picture().width(), light.width());
    EXPECT_LE(guide.document()->size().width(), guide.viewport()->width());
}

TEST(Guide, opensNothingFromOutside) {
    TestWindow shell;
    SheetTab& tab = shell.shown(test::kElevation);
    pressF1(shell.window);
    GuidePanel& guide = guideOf(tab);
    const QString before = guide.toPlainText();
    guide.setSource(QUrl::fromLocalFile(QStringLiteral("/etc/hostname")));
    EXPECT_EQ(guide.toPlainText(), before);
    EXPECT_FALSE(guide.openExternalLinks());
    EXPECT_FALSE(guide.openLinks());
    const QString picture = QStringLiteral(KRIVA_SOURCE_DIR "/resources/screenshots/spline.png");
    ASSERT_TRUE(QFile::exists(picture));
    EXPECT_TRUE(pictureOf(guide, QUrl::fromLocalFile(picture).toString()).isNull());
    EXPECT_TRUE(guide.document()
                    ->resource(QTextDocument::StyleSheetResource, QUrl::fromLocalFile(picture))
                    .toByteArray()
                    .isEmpty());
    EXPECT_TRUE(pictureOf(guide, QStringLiteral("figure:nothing")).isNull());
}

} // namespace
} // namespace kriva::ui
