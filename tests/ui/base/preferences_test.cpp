#include "ui/base/preferences.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QSettings>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

class PreferencesTest : public ::testing::Test {
  protected:
    PreferencesTest() { file.clear(); }
    ~PreferencesTest() override { file.clear(); }

    /// The file itself, as another program could change it.
    QSettings file{QSettings::IniFormat, QSettings::UserScope, u"kriva"_s, u"kriva"_s};
};

TEST_F(PreferencesTest, nothingIsChosenAtFirst) {
    const Preferences preferences;
    EXPECT_EQ(preferences.language(), std::nullopt);
    EXPECT_EQ(preferences.theme(), ThemeChoice::System);
    EXPECT_FALSE(preferences.isSnapping());
    EXPECT_FALSE(preferences.areRulersShown());
    EXPECT_TRUE(preferences.recentFiles().isEmpty());
    EXPECT_TRUE(preferences.windowGeometry().isEmpty());
    EXPECT_TRUE(preferences.panelLayout(u"spline"_s).isEmpty());
}

TEST_F(PreferencesTest, choicesAreThereAtTheNextStart) {
    for (const Language language : kLanguages) {
        Preferences().setLanguage(language);
        EXPECT_EQ(Preferences().language(), language);
    }
    for (const ThemeChoice theme : {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::System}) {
        Preferences().setTheme(theme);
        EXPECT_EQ(Preferences().theme(), theme);
    }
    for (const bool isOn : {true, false}) {
        Preferences().setSnapping(isOn);
        EXPECT_EQ(Preferences().isSnapping(), isOn);
        Preferences().setRulersShown(isOn);
        EXPECT_EQ(Preferences().areRulersShown(), isOn);
    }
    const QByteArray bytes("\0\1\xff", 3);
    Preferences().setWindowGeometry(bytes);
    EXPECT_EQ(Preferences().windowGeometry(), bytes);
}

TEST_F(PreferencesTest, eachTabHasItsOwnPanels) {
    Preferences preferences;
    preferences.setPanelLayout(u"spline"_s, "a");
    preferences.setPanelLayout(u"combined"_s, "b");
    EXPECT_EQ(Preferences().panelLayout(u"spline"_s), "a");
    EXPECT_EQ(Preferences().panelLayout(u"combined"_s), "b");
}

TEST_F(PreferencesTest, theLastFileUsedComesFirstAndTenAreKept) {
    Preferences preferences;
    for (int i = 0; i < 12; ++i)
        preferences.addRecentFile(u"/files/%1.kriva"_s.arg(i));
    preferences.addRecentFile(u"/files/x/../5.kriva"_s);
    const QStringList files = Preferences().recentFiles();
    ASSERT_EQ(files.size(), 10);
    EXPECT_EQ(files[0], u"/files/5.kriva"_s);
    EXPECT_EQ(files[1], u"/files/11.kriva"_s);
    EXPECT_EQ(files.count(u"/files/5.kriva"_s), 1);
}

TEST_F(PreferencesTest, aRelativePathIsRememberedByItsFullName) {
    Preferences preferences;
    preferences.addRecentFile(u"крива.kriva"_s);
    EXPECT_EQ(preferences.recentFiles(), QStringList{QDir::current().absoluteFilePath(u"крива.kriva"_s)});
}

TEST_F(PreferencesTest, aDamagedFileGivesDefaults) {
    QStringList files = {u"relative"_s, u""_s, u"/a"_s, u"/a"_s};
    for (int i = 0; i < 20; ++i)
        files += u"/%1"_s.arg(i);
    file.setValue(u"language"_s, u"xx"_s);
    file.setValue(u"theme"_s, QStringList{u"dark"_s, u"light"_s});
    file.setValue(u"recentFiles"_s, files);
    file.sync();
    const Preferences preferences;
    EXPECT_EQ(preferences.language(), std::nullopt);
    EXPECT_EQ(preferences.theme(), ThemeChoice::System);
    EXPECT_EQ(preferences.recentFiles().size(), 10);
    EXPECT_EQ(preferences.recentFiles()[0], u"/a"_s);
    EXPECT_EQ(preferences.recentFiles()[1], u"/0"_s);
}

} // namespace
} // namespace kriva::ui
