#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>

namespace kriva::ui {
namespace {

using test::TestWindow;

/// Mnemonics that stand for more than one entry of the same menu, with the entries; the menus below included.
QStringList mnemonicsTakenTwice(const QList<QAction*>& entries) {
    QStringList faults;
    QMap<QString, QString> taken;
    for (const QAction* entry : entries) {
        const QString mnemonic = QKeySequence::mnemonic(entry->text()).toString();
        if (!mnemonic.isEmpty() && taken.contains(mnemonic))
            faults.append(mnemonic + QStringLiteral(": ") + taken[mnemonic] + QStringLiteral(", ") + entry->text());
        taken[mnemonic] = entry->text();
        if (entry->menu() != nullptr)
            faults += mnemonicsTakenTwice(entry->menu()->actions());
    }
    return faults;
}

class MnemonicsTest : public testing::TestWithParam<Language> {};

TEST_P(MnemonicsTest, standForOneEntryOfEachMenu) {
    const TestWindow shell(GetParam());
    const QList<QAction*> menus = shell.window.menuBar()->actions();
    ASSERT_FALSE(menus.isEmpty());
    EXPECT_EQ(mnemonicsTakenTwice(menus).join(QLatin1Char('\n')).toStdString(), "");
}

INSTANTIATE_TEST_SUITE_P(InEvery, MnemonicsTest, testing::ValuesIn(kLanguages));

} // namespace
} // namespace kriva::ui
