#include "tests/support/visible_texts.h"
#include "ui/base/language/language.h"
#include "ui/document/sharing/content_hash.h"
#include "ui/window/dialogs/recovery_dialog.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLockFile>
#include <QPushButton>
#include <QTest>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

FoundRecovery foundOf(const QString& path, RecoveryState state) {
    FoundRecovery found;
    found.state = state;
    found.time = QDateTime(QDate(2026, 2, 1), QTime(13, 5));
    if (!path.isEmpty())
        found.note = RecoveryNote{path, {}, {}, {}, found.time};
    return found;
}

class RecoveryDialogTest : public testing::Test {
  protected:
    RecoveryDialogTest() {
        found.push_back(foundOf(u"/home/a/<img src=b>.kriva"_s, RecoveryState::Whole));
        found.push_back(foundOf({}, RecoveryState::Damaged));
        found.push_back(foundOf({}, RecoveryState::Unreadable));
        found.push_back(foundOf(u"/home/a/c.kriva"_s, RecoveryState::Missing));
    }
    [[nodiscard]] static QList<QComboBox*> boxes(RecoveryDialog& dialog) { return dialog.findChildren<QComboBox*>(); }
    static void press(RecoveryDialog& dialog, const QString& button) {
        QTest::mouseClick(dialog.findChild<QPushButton*>(button), Qt::LeftButton);
    }

    LanguageSwitch language{Language::English};
    std::vector<FoundRecovery> found;
};

using Choices = std::vector<RecoveryChoice>;

TEST_F(RecoveryDialogTest, recoversWhatItCanAndDiscardsNothingByItself) {
    RecoveryDialog dialog(found);
    dialog.show();
    press(dialog, u"goOn"_s);
    EXPECT_EQ(dialog.choices(), (Choices{RecoveryChoice::Recover, RecoveryChoice::Recover, RecoveryChoice::Later,
                                         RecoveryChoice::Later}));
}

TEST_F(RecoveryDialogTest, asksForEachDocument) {
    RecoveryDialog dialog(found);
    dialog.show();
    boxes(dialog)[0]->setFocus();
    QTest::keyClicks(boxes(dialog)[0], u"D"_s);
    QTest::keyClicks(boxes(dialog)[1], u"A"_s);
    for (const int nothing : {2, 3})
        EXPECT_EQ(boxes(dialog)[nothing]->findText(u"Recover"_s), -1) << "there is nothing to recover from";
    press(dialog, u"goOn"_s);
    EXPECT_EQ(dialog.choices(),
              (Choices{RecoveryChoice::Discard, RecoveryChoice::Later, RecoveryChoice::Later, RecoveryChoice::Later}));
}

TEST_F(RecoveryDialogTest, closedWithoutAnAnswerEverythingStays) {
    for (const bool byKey : {false, true}) {
        RecoveryDialog dialog(found);
        dialog.show();
        boxes(dialog)[0]->setCurrentIndex(2);
        byKey ? QTest::keyClick(&dialog, Qt::Key_Escape) : press(dialog, u"later"_s);
        EXPECT_EQ(dialog.choices(), Choices(4, RecoveryChoice::Later));
    }
}

TEST_F(RecoveryDialogTest, saysWhatItIsAboutInEveryLanguageWithoutReadingNamesAsHtml) {
    RecoveryDialog dialog(found);
    dialog.show();
    for (const QLabel* label : dialog.findChildren<QLabel*>())
        EXPECT_TRUE(label->textFormat() == Qt::PlainText || label->text().isEmpty());
    const QStringList texts = test::visibleTexts(dialog);
    const QString all = texts.join(u'\n');
    for (const QString& part :
         {u"<img src=b>.kriva"_s, u"/home/a · changed "_s, u"never saved"_s, u"Damaged: look closely"_s,
          u"it cannot be read any more"_s, u"Missing: the unsaved work"_s})
        EXPECT_TRUE(all.contains(part)) << part.toStdString() << " in\n" << all.toStdString();
    for (const Language other : {Language::Bulgarian, Language::Slovenian, Language::Ukrainian}) {
        language.setLanguage(other);
        QApplication::processEvents();
        const QString changed = test::visibleTexts(dialog).join(u'\n');
        for (const QString& part :
             {u"entry: Recover"_s, u"Discard"_s, u"Ask"_s, u"Damaged"_s, u"Missing"_s, u"Continue"_s})
            EXPECT_FALSE(changed.contains(part)) << part.toStdString();
        RecoveryDialog fresh(found);
        EXPECT_EQ(test::visibleTexts(fresh), test::visibleTexts(dialog));
    }
}

} // namespace
} // namespace kriva::ui
