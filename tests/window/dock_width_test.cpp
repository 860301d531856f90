#include "tests/support/test_window.h"

#include <gtest/gtest.h>
#include <QDockWidget>

namespace kriva::ui {
namespace {

using test::TestWindow;

/// The least widths of all docks, by tab and name.
std::map<std::string, int> leastWidths(Language language) {
    TestWindow window(language);
    std::map<std::string, int> widths;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        SheetTab& tab = window.shown(sheet);
        test::seeAllPanels(tab);
        for (const QDockWidget* dock : tab.findChildren<QDockWidget*>())
            widths[std::string(sheetName(sheet)) + ' ' + dock->objectName().toStdString()] =
                dock->widget()->minimumSizeHint().width();
    }
    return widths;
}

TEST(DockWidth, isTheSameInAllLanguages) {
    const std::map<std::string, int> english = leastWidths(Language::English);
    ASSERT_EQ(english.size(), kSheetCount * 9);
    for (const Language language : kLanguages)
        for (const auto& [dock, width] : leastWidths(language))
            EXPECT_EQ(width, english.at(dock)) << dock << " in language " << static_cast<int>(language);
}

TEST(DockWidth, isTheSameInAllTabsAtFirst) {
    TestWindow window(Language::Ukrainian);
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        const SheetTab& tab = window.shown(sheet);
        EXPECT_EQ(tab.findChild<QDockWidget*>(QStringLiteral("points"))->width(), 260);
        EXPECT_EQ(tab.findChild<QDockWidget*>(QStringLiteral("results"))->width(), 360) << "its tabs need the room";
    }
}

std::map<std::string, QSize> sizesOfDocks(const SheetTab& tab) {
    std::map<std::string, QSize> sizes;
    for (const char* dock : {"curves", "points", "properties", "results"})
        sizes[dock] = tab.findChild<QDockWidget*>(QString::fromUtf8(dock))->size();
    return sizes;
}

TEST(DockWidth, andHeightAreTheSameWhenTheProgramStartsAgain) {
    std::map<std::string, QSize> before;
    {
        TestWindow window;
        SheetTab& tab = window.shown(test::kElevation);
        const auto dock = [&](const QString& name) { return tab.findChild<QDockWidget*>(name); };
        tab.resizeDocks({dock(QStringLiteral("properties")), dock(QStringLiteral("results"))}, {420, 250},
                        Qt::Vertical);
        test::settle();
        before = sizesOfDocks(tab);
        window.window.close();
    }
    TestWindow again;
    EXPECT_EQ(again.window.document().value().active, 0U) << "it is shown together with its window";
    test::settle();
    constexpr double kRounding = 2; // px, of Qt's own
    for (const auto& [dock, size] : sizesOfDocks(again.window.tab(test::kElevation))) {
        EXPECT_NEAR(size.width(), before.at(dock).width(), kRounding) << dock;
        EXPECT_NEAR(size.height(), before.at(dock).height(), kRounding) << dock;
    }
}

} // namespace
} // namespace kriva::ui
