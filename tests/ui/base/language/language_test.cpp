#include "ui/base/language/language.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

/// A widget of the kind that the program is made of: its text comes from retranslation alone.
class Cancel : public QLabel {
  public:
    using QLabel::QLabel;
    int changes = 0;

  protected:
    void changeEvent(QEvent* event) override {
        QLabel::changeEvent(event);
        if (event->type() != QEvent::LanguageChange)
            return;
        ++changes;
        setText(QApplication::translate("QPlatformTheme", "Cancel"));
    }
};

class LanguageTest : public ::testing::Test {
  protected:
    ~LanguageTest() override { QLocale::setDefault(QLocale(QLocale::English)); }
};

TEST_F(LanguageTest, everyLanguageHasItsOwnCodeAndName) {
    const std::array names = {u"English"_s, u"Български"_s, u"Slovenščina"_s, u"Українська"_s};
    const std::array codes = {u"en"_s, u"bg"_s, u"sl"_s, u"uk"_s};
    for (std::size_t i = 0; i < kLanguages.size(); ++i) {
        EXPECT_EQ(languageName(kLanguages[i]), names[i]);
        EXPECT_EQ(languageCode(kLanguages[i]), codes[i]);
        EXPECT_EQ(languageOf(codes[i]), kLanguages[i]);
    }
}

TEST_F(LanguageTest, aLocaleNamesItsLanguageWithWhateverFollows) {
    for (const QString& name : {u"bg"_s, u"BG"_s, u"bg_BG.UTF-8"_s, u"bg-Cyrl-BG"_s, u"bg@euro"_s})
        EXPECT_EQ(languageOf(name), Language::Bulgarian) << name.toStdString();
    for (const QString& name : {u""_s, u"C"_s, u"de"_s, u"bgx"_s, u"_bg"_s, u"b"_s})
        EXPECT_EQ(languageOf(name), std::nullopt) << name.toStdString();
}

TEST_F(LanguageTest, theFirstLanguageThatKrivaSpeaksIsTaken) {
    EXPECT_EQ(firstLanguageOf({u"de-DE"_s, u"sl-SI"_s, u"uk-UA"_s}), Language::Slovenian);
    EXPECT_EQ(firstLanguageOf({u"de-DE"_s}), Language::English);
    EXPECT_EQ(firstLanguageOf({}), Language::English);
}

TEST_F(LanguageTest, aWidgetFollowsEverySwitchWithOneEvent) {
    for (const Language from : kLanguages) {
        for (const Language to : kLanguages) {
            if (from == to)
                continue;
            LanguageSwitch fresh(to);
            const QString expected = QApplication::translate("QPlatformTheme", "Cancel");
            fresh.setLanguage(from);
            Cancel label;
            QCoreApplication::sendPostedEvents();
            label.changes = 0;
            fresh.setLanguage(to);
            QCoreApplication::sendPostedEvents();
            EXPECT_EQ(label.changes, 1);
            EXPECT_EQ(label.text(), expected);
            EXPECT_EQ(QLocale().language(), languageLocale(to).language());
        }
    }
}

TEST_F(LanguageTest, languagesDifferInWhatTheySay) {
    LanguageSwitch languages(Language::English);
    QStringList said;
    for (const Language language : kLanguages) {
        languages.setLanguage(language);
        said += QApplication::translate("QPlatformTheme", "Cancel");
    }
    EXPECT_EQ(said, (QStringList{u"Cancel"_s, u"Отказ"_s, u"Prekliči"_s, u"Скасувати"_s}));
}

TEST_F(LanguageTest, theSignalComesOnceAndOnlyForAnotherLanguage) {
    LanguageSwitch languages(Language::English);
    QSignalSpy changed(&languages, &LanguageSwitch::changed);
    languages.setLanguage(Language::English);
    EXPECT_EQ(changed.size(), 0);
    languages.setLanguage(Language::Ukrainian);
    EXPECT_EQ(changed.size(), 1);
    EXPECT_EQ(languages.language(), Language::Ukrainian);
}

TEST_F(LanguageTest, numbersFollowTheLanguage) {
    LanguageSwitch languages(Language::English);
    EXPECT_EQ(QLocale().decimalPoint(), u"."_s);
    for (const Language language : {Language::Bulgarian, Language::Slovenian, Language::Ukrainian}) {
        languages.setLanguage(language);
        EXPECT_EQ(QLocale().decimalPoint(), u","_s);
    }
}

TEST_F(LanguageTest, nothingIsTranslatedAfterItsEnd) {
    { LanguageSwitch languages(Language::Ukrainian); }
    EXPECT_EQ(QApplication::translate("QPlatformTheme", "Cancel"), u"Cancel"_s);
}

TEST_F(LanguageTest, theProgramsOwnCatalogueIsInTheProgram) {
    for (const Language language : kLanguages)
        EXPECT_TRUE(QFile::exists(u":/i18n/kriva_%1.qm"_s.arg(languageCode(language))));
}

} // namespace
} // namespace kriva::ui
