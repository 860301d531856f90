#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QAccessible>

namespace kriva::ui {
namespace {

class CanvasAccessibleTest : public testing::Test {
  protected:
    [[nodiscard]] static QString name(QAccessibleInterface* one) { return one->text(QAccessible::Name); }
    [[nodiscard]] QAccessibleInterface* canvas() { return QAccessible::queryAccessibleInterface(&tab.canvas()); }
    [[nodiscard]] QAccessibleInterface* point(int index) { return canvas()->child(0)->child(index); }

    test::TestWindow shell;
    SheetTab& tab = shell.shown(test::kSpline);
    int pointCount = static_cast<int>(kriva::pointCount(*tab.editor().activeCurve()));
};

TEST_F(CanvasAccessibleTest, listsCurvesAndPoints) {
    EXPECT_EQ(canvas()->role(), QAccessible::Canvas);
    EXPECT_FALSE(name(canvas()).isEmpty());
    ASSERT_EQ(canvas()->childCount(), 1);
    EXPECT_EQ(name(canvas()->child(0)), QStringLiteral("Curve 1"));
    EXPECT_EQ(canvas()->indexOfChild(canvas()->child(0)), 0);
    ASSERT_EQ(canvas()->child(0)->childCount(), pointCount);
    EXPECT_EQ(name(point(2)), QStringLiteral("Point 2"));
    EXPECT_EQ(point(2)->parent(), canvas()->child(0));
    EXPECT_EQ(canvas()->child(0)->indexOfChild(point(2)), 2);
    EXPECT_EQ(canvas()->child(0)->parent(), canvas());
    EXPECT_EQ(canvas()->child(1), nullptr);
    EXPECT_EQ(point(pointCount), nullptr);
}

TEST_F(CanvasAccessibleTest, pointsAreWhereTheyAreDrawn) {
    const QPoint onScreen = tab.canvas().viewport()->mapToGlobal(test::pixelOf(tab, 1));
    EXPECT_TRUE(point(1)->rect().contains(onScreen));
    EXPECT_EQ(canvas()->childAt(onScreen.x(), onScreen.y()), point(1));
    const Point at = pointAt(*tab.editor().activeCurve(), 1);
    EXPECT_EQ(point(1)->text(QAccessible::Value),
              QStringLiteral("x %1; y %2").arg(QLocale().toString(at.x), QLocale().toString(at.y)));
}

TEST_F(CanvasAccessibleTest, choosingAPointSelectsItHereAndInTheTable) {
    QAccessibleActionInterface* actions = point(1)->actionInterface();
    ASSERT_TRUE(actions);
    EXPECT_FALSE(point(1)->state().selected);
    actions->doAction(QAccessibleActionInterface::setFocusAction());
    EXPECT_EQ(tab.editor().selectedPoints(), std::vector{1});
    EXPECT_TRUE(point(1)->state().selected);
    EXPECT_TRUE(point(1)->state().focused);
    EXPECT_EQ(canvas()->focusChild(), point(1));
    EXPECT_FALSE(point(0)->state().selected);
}

TEST_F(CanvasAccessibleTest, whatIsGoneIsInvalid) {
    QAccessibleInterface* last = point(pointCount - 1);
    EXPECT_TRUE(last->isValid());
    tab.editor().removeLastPoint();
    EXPECT_FALSE(last->isValid());
    EXPECT_EQ(canvas()->child(0)->childCount(), pointCount - 1);
    QAccessibleInterface* curve = canvas()->child(0);
    tab.editor().clear();
    EXPECT_FALSE(curve->isValid());
    EXPECT_EQ(canvas()->childCount(), 0);
}

TEST_F(CanvasAccessibleTest, speaksTheLanguage) {
    shell.language.setLanguage(Language::Slovenian);
    QApplication::processEvents();
    EXPECT_EQ(name(point(2)), QStringLiteral("Točka 2"));
    EXPECT_EQ(name(canvas()->child(0)), QStringLiteral("Krivulja 1"));
}

} // namespace
} // namespace kriva::ui
