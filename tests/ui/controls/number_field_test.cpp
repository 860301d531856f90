#include "ui/controls/number_field.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QLocale>
#include <QSignalSpy>
#include <QtTest/QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <cmath>

namespace kriva::ui {
namespace {

/// A window with the field in question and a neighbour that can take the focus.
class NumberFieldTest : public ::testing::Test {
  protected:
    NumberFieldTest() {
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(field = new NumberField);
        layout->addWidget(neighbour = new QLineEdit);
        field->setRange({.lowest = -1000, .highest = 1000});
        field->setValue(0.1);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        field->setFocus();
    }
    ~NumberFieldTest() override { QLocale::setDefault(QLocale(QLocale::English)); }

    /// Replaces the text as a person does: mark all, type.
    void type(const QString& text) {
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
    }
    void press(Qt::Key key) { QTest::keyClick(field, key); }
    void leave() { QTest::keyClick(field, Qt::Key_Tab); }
    void turnWheel(int angle) {
        const QPointF at(5, 5);
        QWheelEvent event(at, field->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        event.ignore();
        QApplication::sendEvent(field, &event);
        wheelWasTaken = event.isAccepted();
    }
    bool isMarked() const {
        return field->palette().color(QPalette::Base) != neighbour->palette().color(QPalette::Base);
    }

    QWidget window;
    NumberField* field = nullptr;
    QLineEdit* neighbour = nullptr;
    bool wheelWasTaken = false;
};

TEST_F(NumberFieldTest, pointAndCommaGiveTheSameNumberInEveryLanguage) {
    for (const char* language : {"en", "bg", "sl", "uk"}) {
        QLocale::setDefault(QLocale(QString::fromLatin1(language)));
        for (const QString& text : {QStringLiteral("1.5"), QStringLiteral("1,5")}) {
            field->setValue(7);
            QSignalSpy committed(field, &NumberField::valueCommitted);
            type(text);
            press(Qt::Key_Return);
            ASSERT_EQ(committed.size(), 1) << language;
            EXPECT_EQ(committed[0][0].toDouble(), 1.5);
            EXPECT_EQ(field->text(), QLocale().decimalPoint() == u"," ? u"1,5" : u"1.5");
        }
    }
}

TEST_F(NumberFieldTest, showingFocusingAndLeavingChangesNoBit) {
    const double third = 1.0 / 3;
    QSignalSpy committed(field, &NumberField::valueCommitted);
    field->setValue(third);
    field->setFocus();
    press(Qt::Key_End);
    leave();
    EXPECT_EQ(committed.size(), 0);
    EXPECT_EQ(field->value(), third);
}

TEST_F(NumberFieldTest, aLongNumberShowsItsFirstDigits) {
    neighbour->setFocus();
    field->setValue(1.0 / 3);
    EXPECT_EQ(field->cursorPosition(), 0);
}

TEST_F(NumberFieldTest, typingCommitsOnceHoweverItEnds) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    type(QStringLiteral("-2,25"));
    EXPECT_EQ(committed.size(), 0) << "nothing is applied while typing";
    press(Qt::Key_Enter);
    leave();
    ASSERT_EQ(committed.size(), 1);
    EXPECT_EQ(committed[0][0].toDouble(), -2.25);
    field->setFocus();
    type(QStringLiteral("1e-7"));
    leave();
    ASSERT_EQ(committed.size(), 2);
    EXPECT_EQ(committed[1][0].toDouble(), 1e-7);
}

TEST_F(NumberFieldTest, anotherSpellingOfTheHeldNumberIsNoCommit) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    type(QStringLiteral("0,10"));
    press(Qt::Key_Return);
    EXPECT_EQ(committed.size(), 0);
    EXPECT_EQ(field->text(), u"0.1");
}

TEST_F(NumberFieldTest, whatIsNoNumberOfTheRangeStaysMarkedAndIsNotApplied) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    for (const QString& text : {QStringLiteral("1.234,5"), QStringLiteral("1 234"), QStringLiteral("nan"),
                                QStringLiteral("1e999"), QStringLiteral("1001"), QStringLiteral("x")}) {
        type(text);
        EXPECT_EQ(field->text(), text) << "no key is dropped";
        EXPECT_TRUE(isMarked()) << text.toStdString();
        EXPECT_TRUE(field->accessibleDescription().contains(QStringLiteral("1000")));
        press(Qt::Key_Return);
        EXPECT_FALSE(field->commit());
        EXPECT_EQ(field->text(), text);
    }
    EXPECT_EQ(committed.size(), 0);
    EXPECT_EQ(field->value(), 0.1);
    EXPECT_TRUE(isMarked());
    field->setValue(3);
    EXPECT_FALSE(isMarked());
    EXPECT_TRUE(field->accessibleDescription().isEmpty());
}

TEST_F(NumberFieldTest, aRefusedTextGivesWayToWhatHoldsWhenTheFieldIsLeft) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    type(QStringLiteral("1001"));
    press(Qt::Key_Return);
    EXPECT_TRUE(isMarked());
    leave();
    EXPECT_EQ(field->text(), u"0.1");
    EXPECT_FALSE(isMarked());
    EXPECT_TRUE(field->accessibleDescription().isEmpty());
    field->setFocus();
    EXPECT_EQ(field->text(), u"0.1");
    type(QStringLiteral("x"));
    field->hide();
    EXPECT_EQ(field->text(), u"0.1") << "a field that goes out of sight is left as well";
    EXPECT_EQ(committed.size(), 0);
}

TEST_F(NumberFieldTest, aRefusedTextIsToldInTheLanguageAndGivesWayToAnotherValue) {
    type(QStringLiteral("1000,5"));
    EXPECT_TRUE(isMarked());
    QLocale::setDefault(QLocale(QLocale::Slovenian));
    QEvent change(QEvent::LanguageChange);
    QApplication::sendEvent(field, &change);
    EXPECT_EQ(field->text(), u"1000,5") << "still being typed";
    EXPECT_TRUE(isMarked());
    field->setValue(0.2); // as undo does
    EXPECT_EQ(field->text(), u"0,2");
    EXPECT_FALSE(isMarked());
}

TEST_F(NumberFieldTest, noNumberIsAnEmptyTextUntilOneIsTyped) {
    field->setValue(std::nan(""));
    EXPECT_EQ(field->text(), QString());
    EXPECT_FALSE(isMarked());
    QSignalSpy committed(field, &NumberField::valueCommitted);
    press(Qt::Key_Up);
    leave();
    EXPECT_EQ(committed.size(), 0);
    field->setFocus();
    type(QStringLiteral("0"));
    leave();
    EXPECT_EQ(committed.size(), 1);
    EXPECT_EQ(field->value(), 0);
}

TEST_F(NumberFieldTest, escapeBringsTheHeldNumberBack) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    type(QStringLiteral("abc"));
    press(Qt::Key_Escape);
    EXPECT_EQ(field->text(), u"0.1");
    EXPECT_FALSE(isMarked());
    leave();
    EXPECT_EQ(committed.size(), 0);
}

TEST_F(NumberFieldTest, aValueFromOutsideReplacesTypedTextOnlyIfItIsAnother) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    type(QStringLiteral("12"));
    field->setValue(0.1);
    EXPECT_EQ(field->text(), u"12");
    field->setValue(0.2);
    EXPECT_EQ(field->text(), u"0.2");
    field->setValue(-0.0);
    field->setValue(0.0);
    EXPECT_FALSE(std::signbit(field->value()));
    EXPECT_EQ(committed.size(), 0);
}

TEST_F(NumberFieldTest, arrowsStepWithinTheRange) {
    QSignalSpy committed(field, &NumberField::valueCommitted);
    field->setStep(0.2);
    press(Qt::Key_Up);
    EXPECT_EQ(field->value(), 0.3);
    press(Qt::Key_Down);
    EXPECT_EQ(field->value(), 0.1);
    EXPECT_EQ(committed.size(), 2);
    field->setValue(999.9);
    press(Qt::Key_Up);
    EXPECT_EQ(field->value(), 1000);
    press(Qt::Key_Up);
    EXPECT_EQ(committed.size(), 3) << "at the end of the range nothing changes";
}

TEST_F(NumberFieldTest, excludedEndsAreNeitherTypedNorSteppedTo) {
    field->setRange({.lowest = 0, .highest = 1, .endsExcluded = true});
    field->setStep(0.1);
    press(Qt::Key_Down);
    EXPECT_EQ(field->value(), 0.1);
    type(QStringLiteral("1"));
    EXPECT_FALSE(field->commit());
    type(QStringLiteral("0.999"));
    EXPECT_TRUE(field->commit());
}

TEST_F(NumberFieldTest, wholeNumbersMayBeSpeltWithADecimalSign) {
    field->setRange({.lowest = 0, .highest = 16, .isWhole = true});
    type(QStringLiteral("2.5"));
    EXPECT_FALSE(field->commit());
    type(QStringLiteral("5,0"));
    EXPECT_TRUE(field->commit());
    EXPECT_EQ(field->value(), 5);
    EXPECT_EQ(field->text(), u"5");
}

TEST_F(NumberFieldTest, theWheelStepsOnlyAFocusedField) {
    field->setValue(1);
    turnWheel(60);
    EXPECT_EQ(field->value(), 1) << "half a notch";
    turnWheel(60);
    EXPECT_EQ(field->value(), 2);
    neighbour->setFocus();
    turnWheel(120);
    EXPECT_EQ(field->value(), 2);
    EXPECT_FALSE(wheelWasTaken) << "the scroll area around it scrolls";
}

TEST_F(NumberFieldTest, undoKeysBelongToTheDocumentUntilSomethingIsTyped) {
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    QApplication::sendEvent(field, &undo);
    EXPECT_FALSE(undo.isAccepted());
    type(QStringLiteral("4"));
    QApplication::sendEvent(field, &undo);
    EXPECT_TRUE(undo.isAccepted());
}

TEST_F(NumberFieldTest, theShownNumberFollowsTheLanguageButTypedTextStays) {
    QLocale::setDefault(QLocale(QLocale::Slovenian));
    QEvent change(QEvent::LanguageChange);
    QApplication::sendEvent(field, &change);
    EXPECT_EQ(field->text(), u"0,1");
    type(QStringLiteral("0.25"));
    QLocale::setDefault(QLocale(QLocale::English));
    QApplication::sendEvent(field, &change);
    EXPECT_EQ(field->text(), u"0.25");
    EXPECT_EQ(field->value(), 0.1);
}

TEST_F(NumberFieldTest, aReadOnlyFieldDoesNotStep) {
    field->setReadOnly(true);
    press(Qt::Key_Up);
    turnWheel(120);
    EXPECT_EQ(field->value(), 0.1);
}

} // namespace
} // namespace kriva::ui
