#include "tests/support/test_window.h"
#include "ui/panels/guide/guide_panel.h"
#include "ui/window/actions/menus.h"

#include <gtest/gtest.h>
#include <QLabel>
#include <QStatusBar>

namespace kriva::ui {
namespace {

using test::TestWindow;

class ExamplesTest : public testing::TestWithParam<Language> {
  protected:
    [[nodiscard]] QString translated(const Example& example) const {
        return QCoreApplication::translate("Examples", example.lookAt);
    }
    /// The entry of the menu.
    [[nodiscard]] QAction* entry(const Example& example) {
        const QString name = QCoreApplication::translate("Menus", example.name);
        for (QMenu* menu : shell.window.findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (action->text() == name)
                    return action;
        return nullptr;
    }
    [[nodiscard]] QString guide() {
        SheetTab& tab = shell.window.currentTab();
        tab.panels().showGuide();
        test::settle();
        return tab.findChild<GuidePanel*>()->toPlainText();
    }
    [[nodiscard]] bool isInStatusRow(const QString& text) {
        const QList<QLabel*> labels = shell.window.statusBar()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == text; });
    }

    TestWindow shell{GetParam()};
};

TEST_P(ExamplesTest, openEachFromTheMenuAndSayWhatToLookAt) {
    ASSERT_EQ(examples().size(), 9u);
    for (const Example& example : examples()) {
        const QString line = translated(example);
        ASSERT_NE(entry(example), nullptr) << example.name;
        EXPECT_EQ(entry(example)->toolTip(), line);
        EXPECT_GT(line.size(), 40);
        EXPECT_EQ(line == QString::fromUtf8(example.lookAt), GetParam() == Language::English) << example.lookAt;
        entry(example)->trigger();
        test::settle();
        const Document& shown = shell.window.document().value();
        EXPECT_EQ(shown, exampleDocument(QString::fromLatin1(example.resource)));
        EXPECT_FALSE(shell.window.isWindowModified());
        EXPECT_TRUE(isInStatusRow(line)) << line.toStdString();
        EXPECT_TRUE(
            guide().trimmed().startsWith(QCoreApplication::translate("Menus", example.name) + QLatin1Char('\n') + line))
            << guide().left(200).toStdString();
    }
}

TEST_P(ExamplesTest, takeTheirLineAlongWhenAnotherDocumentComes) {
    const Example& example = examples()[1];
    entry(example)->trigger();
    EXPECT_TRUE(guide().contains(translated(example)));
    shell.window.session().newDocument();
    test::settle();
    EXPECT_FALSE(guide().contains(translated(example)));
}

TEST_P(ExamplesTest, sayItInTheLanguageThatIsChosenLater) {
    const Example& example = examples()[8];
    entry(example)->trigger();
    ASSERT_TRUE(guide().contains(translated(example)));
    shell.language.setLanguage(GetParam() == Language::Ukrainian ? Language::Bulgarian : Language::Ukrainian);
    QApplication::sendPostedEvents();
    test::settle();
    EXPECT_TRUE(guide().contains(translated(example)));
}

INSTANTIATE_TEST_SUITE_P(Languages, ExamplesTest, testing::ValuesIn(kLanguages),
                         [](const auto& one) { return languageCode(one.param).toStdString(); });

} // namespace
} // namespace kriva::ui
