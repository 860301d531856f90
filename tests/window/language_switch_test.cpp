#include "tests/support/test_window.h"
#include "tests/support/visible_texts.h"
#include "ui/window/dialogs/about_dialog.h"

#include <gtest/gtest.h>
#include <QMessageBox>

namespace kriva::ui {
namespace {

using test::TestWindow;
using test::visibleTexts;

/// A window that has been worked in, with every panel shown and dialogs open.
struct BusyWindow {
    explicit BusyWindow(Language language)
        : shell(language) {
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
            SheetTab& tab = shell.shown(sheet);
            SheetEditor& editor = tab.editor();
            editor.addPoint({2.5, 1.25});
            editor.newCurve();
            editor.addPoint({0, 0.5});
            editor.deleteCurve(editor.activeSerial());
            editor.reverse();
            editor.placePoint(0, {0.125, -1});
            for (QAction* panel : tab.panels().actions())
                if (!panel->isChecked())
                    panel->trigger();
            test::seeAllPanels(tab);
        }
        about.show();
        question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
        question.show();
        settle();
    }
    void settle() {
        QApplication::sendPostedEvents();
        test::settle();
    }
    QStringList texts() {
        QStringList all = visibleTexts(shell.window);
        all += visibleTexts(about);
        all += visibleTexts(question);
        return all;
    }

    TestWindow shell;
    AboutDialog about;
    QMessageBox question;
};

class LanguageSwitchTest : public testing::TestWithParam<std::tuple<Language, Language>> {};

TEST_P(LanguageSwitchTest, leavesNothingOfTheFormerLanguage) {
    const auto [from, to] = GetParam();
    if (from == to)
        GTEST_SKIP() << "no switch";
    QStringList fresh;
    {
        BusyWindow window(to);
        fresh = window.texts();
    }
    BusyWindow window(from);
    const Document before = window.shell.window.document().value();
    const Selection selection = window.shell.window.currentTab().editor().selection();
    const QByteArray layout = window.shell.window.currentTab().saveState();
    window.shell.language.setLanguage(to);
    window.settle();
    const QStringList switched = window.texts();
    for (const QString& text : switched)
        EXPECT_TRUE(fresh.contains(text)) << "not so in a fresh start: " << text.toStdString();
    for (const QString& text : fresh)
        EXPECT_TRUE(switched.contains(text)) << "only so in a fresh start: " << text.toStdString();
    EXPECT_EQ(window.shell.window.document().value(), before);
    EXPECT_EQ(window.shell.window.currentTab().editor().selection(), selection);
    EXPECT_EQ(window.shell.window.currentTab().saveState(), layout);
}

INSTANTIATE_TEST_SUITE_P(BetweenAll, LanguageSwitchTest,
                         testing::Combine(testing::ValuesIn(kLanguages), testing::ValuesIn(kLanguages)));

} // namespace
} // namespace kriva::ui
