#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QAccessible>

#include <set>

namespace kriva::ui {
namespace {

/// A name for the failure of a test: the widget with its parents.
std::string pathOf(const QWidget* widget) {
    QString path;
    for (const QObject* one = widget; one; one = one->parent())
        path.prepend(u'/' + QString::fromLatin1(one->metaObject()->className()) + u':' + one->objectName());
    return path.toStdString();
}

bool isInTabOrder(const QWidget& widget) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0;
}

class AccessibleNames : public testing::TestWithParam<Language> {
  protected:
    /// All that Tab can reach in the tab that is shown.
    [[nodiscard]] QList<QWidget*> focusable() {
        QList<QWidget*> found;
        for (QWidget* widget : shell.window.findChildren<QWidget*>())
            if (widget->isVisible() && widget->isEnabled() && !widget->focusProxy() && isInTabOrder(*widget))
                found.append(widget);
        return found;
    }

    test::TestWindow shell{GetParam()};
};

TEST_P(AccessibleNames, everyFocusableWidgetHasANameAndARole) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        shell.shown(sheet);
        EXPECT_GT(focusable().size(), 8);
        for (const QWidget* widget : focusable()) {
            QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
            ASSERT_TRUE(seen) << pathOf(widget);
            EXPECT_FALSE(seen->text(QAccessible::Name).isEmpty()) << pathOf(widget);
            EXPECT_NE(seen->role(), QAccessible::NoRole) << pathOf(widget);
        }
    }
}

TEST_P(AccessibleNames, tabReachesEveryFocusableWidgetAndComesBack) {
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        shell.shown(sheet);
        const QList<QWidget*> all = focusable();
        std::set<const QWidget*> reached;
        // The chain of the window, in which Tab goes.
        const QWidget* first = &shell.window;
        for (const QWidget* one = first->nextInFocusChain(); one != first; one = one->nextInFocusChain())
            reached.insert(one);
        for (const QWidget* widget : all)
            EXPECT_TRUE(reached.contains(widget)) << pathOf(widget);
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, AccessibleNames, testing::ValuesIn(kLanguages),
                         [](const auto& one) { return languageCode(one.param).toStdString(); });

} // namespace
} // namespace kriva::ui
