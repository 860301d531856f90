#include "tests/support/test_window.h"
#include "ui/controls/number_field.h"

#include <gtest/gtest.h>
#include <QAbstractItemView>
#include <QClipboard>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>

#include <set>

// The keyboard alone, through a real display: keys go the way from the server over the layout and the window manager.
// They are pressed by their place on the keyboard, so that the layout decides what they mean.
namespace kriva::ui {
namespace {

/// The codes of an X server for the places of a PC keyboard.
int codeOf(char place) {
    constexpr std::pair<int, std::string_view> kRows[] = {
        {10, "1234567890"}, {24, "QWERTYUIOP"}, {38, "ASDFGHJKL"}, {52, "ZXCVBNM"}};
    for (const auto& [first, keys] : kRows)
        if (const auto at = keys.find(place); at != std::string_view::npos)
            return first + static_cast<int>(at);
    return 0;
}
constexpr int kControl = 37;
constexpr int kShift = 50;
constexpr int kAlt = 64;
constexpr int kEscape = 9;
constexpr int kTab = 23;
constexpr int kReturn = 36;
constexpr int kUp = 111;
constexpr int kLeft = 113;
constexpr int kRight = 114;
constexpr int kDown = 116;
constexpr int kInsert = 118;
constexpr int kDelete = 119;
constexpr int kMenu = 135;

/// As xdotool wants it, to which a single digit is that digit's key.
QString nameOf(int code) {
    return code == kEscape ? QStringLiteral("Escape") : QString::number(code);
}

class KeyboardTest : public testing::Test {
  protected:
    KeyboardTest() {
        shell.window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&shell.window));
    }

    /// Presses the keys one in the other and lets go of them.
    static void press(std::initializer_list<int> codes) {
        QStringList words;
        for (const int code : codes)
            words << QStringLiteral("keydown") << nameOf(code);
        for (auto code = std::rbegin(codes); code != std::rend(codes); ++code)
            words << QStringLiteral("keyup") << nameOf(*code);
        QProcess::execute(QStringLiteral("xdotool"), words);
        QApplication::processEvents();
    }
    template <class Condition>
    [[nodiscard]] static bool comesTrue(Condition condition) {
        return QTest::qWaitFor(condition, 5000);
    }
    SheetTab& spline() {
        SheetTab& tab = shell.shown(test::kSpline);
        tab.canvas().setFocus();
        return tab;
    }

    test::TestWindow shell;
};

/// Walks through open menus and notes which entries light up.
class MenuWalk : public KeyboardTest {
  protected:
    static void leavesOf(const QList<QAction*>& entries, std::set<QAction*>& leaves) {
        for (QAction* entry : entries) {
            if (entry->menu() && entry->isEnabled())
                leavesOf(entry->menu()->actions(), leaves);
            else if (entry->isEnabled() && entry->isVisible() && !entry->isSeparator() && !entry->menu())
                leaves.insert(entry);
        }
    }
    void walk(QMenu& menu) {
        for (QAction* entry : menu.actions()) {
            if (!entry->isEnabled() || entry->isSeparator() || !entry->isVisible())
                continue;
            ASSERT_TRUE(comesTrue([&] { return menu.activeAction() == entry; })) << entry->text().toStdString();
            if (entry->menu()) {
                press({kRight});
                ASSERT_TRUE(comesTrue([&] { return entry->menu()->isVisible(); })) << entry->text().toStdString();
                walk(*entry->menu());
                press({kLeft});
                ASSERT_TRUE(comesTrue([&] { return !entry->menu()->isVisible(); }));
            } else {
                reached.insert(entry);
            }
            press({kDown});
        }
    }

    std::set<QAction*> reached;
};

TEST_F(MenuWalk, reachesEveryAction) {
    spline().editor().selectAll();
    for (QAction* title : shell.window.menuBar()->actions()) {
        const QString mnemonic = QKeySequence::mnemonic(title->text()).toString(); // "Alt+F"
        press({kAlt, codeOf(mnemonic.back().toLatin1())});
        ASSERT_TRUE(comesTrue([&] { return title->menu()->isVisible(); })) << mnemonic.toStdString();
        if (!title->menu()->activeAction())
            press({kDown});
        walk(*title->menu());
        press({kEscape});
        EXPECT_TRUE(comesTrue([&] { return !title->menu()->isVisible(); }));
        press({kEscape});
    }
    std::set<QAction*> all;
    leavesOf(shell.window.menuBar()->actions(), all);
    for (QAction* action : all)
        EXPECT_TRUE(reached.contains(action)) << action->text().toStdString();
    EXPECT_GT(reached.size(), 40U);
}

TEST_F(KeyboardTest, altAloneLeavesTheFocusWhereItIs) {
    SheetTab& tab = spline();
    press({kAlt});
    EXPECT_TRUE(tab.canvas().hasFocus());
    EXPECT_FALSE(shell.window.menuBar()->activeAction());
}

TEST_F(KeyboardTest, singleKeysGoByTheirPlace) {
    CanvasView& canvas = spline().canvas();
    press({codeOf('B')});
    EXPECT_TRUE(comesTrue([&] { return canvas.tool() == Tool::add; }));
    press({codeOf('V')});
    EXPECT_TRUE(comesTrue([&] { return canvas.tool() == Tool::edit; }));
    const bool hadGrid = canvas.scene().isGridShown();
    press({codeOf('G')});
    EXPECT_TRUE(comesTrue([&] { return canvas.scene().isGridShown() != hadGrid; }));
}

TEST_F(KeyboardTest, pointsAreChosenMovedJoinedAndRemoved) {
    SheetTab& tab = spline();
    const Curve before = *tab.editor().activeCurve();
    press({kTab});
    ASSERT_TRUE(comesTrue([&] { return tab.editor().selectedPoints() == std::vector{0}; }));
    press({kTab});
    ASSERT_TRUE(comesTrue([&] { return tab.editor().selectedPoints() == std::vector{1}; }));
    press({kShift, kUp});
    ASSERT_TRUE(comesTrue([&] { return pointAt(*tab.editor().activeCurve(), 1).y > pointAt(before, 1).y; }));
    press({kShift, codeOf('C')});
    ASSERT_TRUE(comesTrue(
        [&] { return std::get<SplineCurve>(*tab.editor().activeCurve()).knots[1].join == SplineKnot::Join::corner; }));
    press({kDelete});
    ASSERT_TRUE(comesTrue([&] { return pointCount(*tab.editor().activeCurve()) == pointCount(before) - 1; }));
    press({kControl, codeOf('Z')});
    ASSERT_TRUE(comesTrue([&] { return pointCount(*tab.editor().activeCurve()) == pointCount(before); }));
    press({kInsert});
    ASSERT_TRUE(comesTrue([&] { return pointCount(*tab.editor().activeCurve()) == pointCount(before) + 1; }));
}

TEST_F(KeyboardTest, fieldsHaveShortcutsOfTheirOwn) {
    auto* degree = spline().findChild<NumberField*>();
    ASSERT_TRUE(degree);
    degree->setFocus();
    press({kControl, codeOf('A')});
    ASSERT_TRUE(comesTrue([&] { return degree->selectedText() == degree->text(); }));
    press({kControl, codeOf('C')});
    EXPECT_TRUE(comesTrue([&] { return QGuiApplication::clipboard()->text() == degree->text(); }));
}

TEST_F(KeyboardTest, tabsAreSwitchedByAltAndANumber) {
    for (SheetIndex sheet = kSheetCount; sheet-- > 0;) {
        press({kAlt, codeOf("1234"[sheet])});
        EXPECT_TRUE(comesTrue([&] { return shell.window.document().value().active == sheet; })) << sheet;
    }
}

TEST_F(KeyboardTest, theMenuKeyOpensAContextMenuThatArrowsWalk) {
    SheetTab& tab = spline();
    press({kTab});
    ASSERT_TRUE(comesTrue([&] { return !tab.editor().selection().empty(); }));
    press({kMenu});
    ASSERT_TRUE(comesTrue([] { return qobject_cast<QMenu*>(QApplication::activePopupWidget()) != nullptr; }));
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    press({kDown});
    EXPECT_TRUE(comesTrue([&] { return menu->activeAction() != nullptr; }));
    press({kEscape});
    EXPECT_TRUE(comesTrue([] { return QApplication::activePopupWidget() == nullptr; }));
}

TEST_F(KeyboardTest, tabWalksThroughTheWholeWindow) {
    SheetTab& tab = spline();
    std::set<QWidget*> reached;
    for (int i = 0; i < 120; ++i) {
        press({kTab});
        if (QWidget* focus = QApplication::focusWidget())
            reached.insert(focus);
    }
    for (const char* name : {"curves", "points", "results"})
        EXPECT_TRUE(reached.contains(tab.findChild<QAbstractItemView*>(QString::fromLatin1(name)))) << name;
    EXPECT_TRUE(reached.contains(&tab.canvas()));
}

} // namespace
} // namespace kriva::ui
