#include "tests/support/test_window.h"
#include "ui/window/dialogs/gesture_table.h"
#include "ui/window/shortcuts_dialog.h"

#include <gtest/gtest.h>
#include <QLineEdit>
#include <QShortcut>
#include <QTreeWidget>

namespace kriva::ui {
namespace {

using test::TestWindow;

/// "what: keys" of all rows that are seen.
QStringList rowsOf(const QTreeWidget& list) {
    QStringList rows;
    for (int i = 0; i < list.topLevelItemCount(); ++i) {
        const QTreeWidgetItem* group = list.topLevelItem(i);
        for (int k = 0; k < group->childCount() && !group->isHidden(); ++k)
            if (!group->child(k)->isHidden())
                rows.append(group->child(k)->text(0) + QStringLiteral(": ") + group->child(k)->text(1));
    }
    return rows;
}

struct OpenSheet {
    explicit OpenSheet(Language language = Language::English)
        : shell(language) {
        reopen();
    }
    void reopen() {
        delete shell.window.findChild<ShortcutsDialog*>();
        shell.window.findChild<QAction*>(QStringLiteral("shortcuts"))->trigger();
        test::settle();
        dialog = shell.window.findChild<ShortcutsDialog*>();
        list = dialog->findChild<QTreeWidget*>();
        filter = dialog->findChild<QLineEdit*>();
    }
    [[nodiscard]] QStringList rows() const { return rowsOf(*list); }

    TestWindow shell;
    ShortcutsDialog* dialog;
    QTreeWidget* list;
    QLineEdit* filter;
};

class ShortcutsTest : public testing::TestWithParam<Language> {};

TEST_P(ShortcutsTest, listEveryActionThatHasOne) {
    OpenSheet sheet(GetParam());
    const QStringList rows = sheet.rows();
    int actions = 0;
    for (const QAction* action : sheet.shell.window.findChildren<QAction*>()) {
        if (action->shortcuts().isEmpty() || action->text().isEmpty())
            continue;
        ++actions;
        const QString row = action->text().remove(QLatin1Char('&')) + QStringLiteral(": ") +
                            QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
        EXPECT_TRUE(rows.contains(row)) << row.toStdString();
    }
    EXPECT_GT(actions, 30);
}

TEST_P(ShortcutsTest, haveWordsForEveryGesture) {
    OpenSheet sheet(GetParam());
    std::size_t gestures = 0;
    for (const GestureGroup& group : gestureTable())
        gestures += group.gestures.size();
    EXPECT_GT(gestures, 40);
    for (const QString& row : sheet.rows()) {
        EXPECT_FALSE(row.startsWith(QLatin1String(": "))) << row.toStdString();
        EXPECT_FALSE(row.endsWith(QLatin1String(": "))) << row.toStdString();
    }
}

TEST_P(ShortcutsTest, followTheLanguageWhileTheyAreOpen) {
    const QStringList fresh = OpenSheet(GetParam()).rows();
    OpenSheet sheet(GetParam() == Language::English ? Language::Slovenian : Language::English);
    EXPECT_NE(sheet.rows(), fresh);
    sheet.shell.language.setLanguage(GetParam());
    QApplication::sendPostedEvents();
    test::settle();
    EXPECT_EQ(sheet.rows(), fresh);
}

INSTANTIATE_TEST_SUITE_P(Languages, ShortcutsTest, testing::ValuesIn(kLanguages),
                         [](const auto& one) { return languageCode(one.param).toStdString(); });

TEST(Shortcuts, knowTheTabsAndTheSingleKeys) {
    const OpenSheet sheet;
    const QStringList rows = sheet.rows();
    for (const char* row : {"Show a tab: Alt+1 … Alt+4", "Edit tool: V", "Add tool: B", "Grid: G",
                            "Fit the selection: 3", "User guide: F1", "Corner: Shift+C", "Elevate once more: PgUp",
                            "One level fewer: PgDown", "Retract the handle: Ctrl+click", "Undo: Ctrl+Z"})
        EXPECT_TRUE(rows.contains(QString::fromUtf8(row))) << row << '\n' << rows.join(u'\n').toStdString();
}

TEST(Shortcuts, areTheSameWhicheverTabIsShownAndWhateverCanBeUndone) {
    OpenSheet sheet;
    const QStringList before = sheet.rows();
    for (SheetIndex tab = 0; tab < kSheetCount; ++tab) {
        sheet.shell.shown(tab).editor().reverse();
        sheet.reopen();
        EXPECT_EQ(sheet.rows(), before);
    }
}

TEST(Shortcuts, areNarrowedByWhatIsTyped) {
    OpenSheet sheet;
    const qsizetype all = sheet.rows().size();
    QTest::keyClicks(sheet.filter, QStringLiteral("ctrl+shift"));
    const QStringList few = sheet.rows();
    EXPECT_GT(few.size(), 3);
    EXPECT_LT(few.size(), all / 4);
    for (const QString& row : few)
        EXPECT_TRUE(row.contains(QLatin1String("Ctrl+Shift"))) << row.toStdString();
    sheet.filter->setText(QStringLiteral("no such thing"));
    EXPECT_TRUE(sheet.rows().isEmpty());
    sheet.filter->clear();
    EXPECT_EQ(sheet.rows().size(), all);
}

TEST(Shortcuts, leaveTheWindowFree) {
    OpenSheet sheet;
    EXPECT_FALSE(sheet.dialog->isModal());
    sheet.shell.window.findChild<QAction*>(QStringLiteral("shortcuts"))->trigger();
    EXPECT_EQ(sheet.shell.window.findChildren<ShortcutsDialog*>().size(), 1) << "one sheet is enough";
}

} // namespace
} // namespace kriva::ui
